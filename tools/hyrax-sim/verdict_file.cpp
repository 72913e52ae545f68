#include "tools/hyrax-sim/verdict_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "tools/files/failure.h"
#include "tools/files/json_pointer.h"
#include "tools/files/text_file.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

constexpr std::string_view kFormat = "hyrax-verdicts/1";

// Reads the file, and keeps all that is wrong with it until the end.
class VerdictReader {
 public:
  VerdictReader(const std::string& path, const std::vector<Claim>& claims)
      : path_(path), claims_(claims), document_(parse_json(read_text_file(path), path)) {}

  [[nodiscard]] std::vector<std::string> unexpected() {
    const Json::Object* const members = document_.get<Json::Object>();
    if (members == nullptr) refuse("", "must be an object with the keys format, verdicts");
    for (const auto& [key, value] : members != nullptr ? *members : Json::Object{}) {
      if (key == "format")
        see_format(value);
      else if (key == "verdicts")
        see_verdicts(value);
      else
        refuse("/" + key, unknown_word("key", key, {"format", "verdicts"}));
    }
    if (members != nullptr && document_.find("format") == nullptr) refuse("/format", "is missing");
    if (members != nullptr && document_.find("verdicts") == nullptr) refuse("/verdicts", "is missing");
    if (!faults_.empty()) throw Failure(ExitCode::bad_input, faults_);
    for (const Claim& claim : claims_)
      if (seen_.count(claim.id) == 0)
        unexpected_.push_back(
            fmt::format("{}: {}, of which {} says nothing", claim.id, name_of(claim.verdict), path_));
    return unexpected_;
  }

 private:
  void refuse(const std::string& place, const std::string& rule) {
    faults_ +=
        fmt::format("{}{}: {}: {}", faults_.empty() ? "" : "\n", path_, place.empty() ? "/" : place, rule);
  }

  void see_format(const Json& value) {
    const std::string* const format = value.get<std::string>();
    if (format == nullptr || *format != kFormat)
      refuse("/format", fmt::format("must be \"{}\", is {}", kFormat, to_text(value)));
  }

  void see_verdicts(const Json& value) {
    const Json::Object* const verdicts = value.get<Json::Object>();
    if (verdicts == nullptr) return refuse("/verdicts", "must be an object, a verdict for each claim");
    for (const auto& [id, verdict] : *verdicts) see_verdict(id, verdict);
  }

  void see_verdict(const std::string& id, const Json& verdict) {
    const std::string place = pointer_to("/verdicts", id);
    const auto claim =
        std::find_if(claims_.begin(), claims_.end(), [&](const Claim& each) { return each.id == id; });
    if (claim == claims_.end()) return refuse(place, "is no claim; `hyrax-sim study paper` lists them");
    if (!seen_.insert(id).second) return refuse(place, "stands twice");
    const std::string* const expected = verdict.get<std::string>();
    const std::vector<std::string_view> allowed(kClaimVerdictNames.begin(), kClaimVerdictNames.end());
    if (expected == nullptr || std::find(allowed.begin(), allowed.end(), *expected) == allowed.end())
      return refuse(place,
                    unknown_word("value", expected != nullptr ? *expected : to_text(verdict), allowed));
    if (*expected != name_of(claim->verdict))
      unexpected_.push_back(fmt::format("{}: {}, where {} expects: {} ({}: {} {})", id,
                                        name_of(claim->verdict), path_, *expected, claim->measured,
                                        claim->number, claim->unit));
  }

  const std::string& path_;
  const std::vector<Claim>& claims_;
  Json document_;
  std::set<std::string> seen_;
  std::string faults_;
  std::vector<std::string> unexpected_;
};

}  // namespace

std::vector<std::string> unexpected_verdicts(const std::string& path, const std::vector<Claim>& claims) {
  return VerdictReader(path, claims).unexpected();
}

}  // namespace hyrax
