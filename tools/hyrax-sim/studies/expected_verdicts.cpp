#include "tools/hyrax-sim/studies/expected_verdicts.h"

#include <set>

#include "tools/files/failure.h"
#include "tools/files/json_pointer.h"
#include "tools/files/text_file.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

constexpr std::string_view kFormat = "hyrax-verdicts/1";

// Reads the file and collects every fault.
class Reader {
 public:
  explicit Reader(const std::string& path)
      : expected_{path, {}}, document_(parse_json(read_text_file(path), path)) {}

  [[nodiscard]] ExpectedVerdicts read() {
    const Json::Object* const members = document_.get<Json::Object>();
    if (members == nullptr) {
      refuse("/", "must be an object with the keys format, verdicts");
    } else {
      for (const auto& [key, value] : *members) read_member(key, value);
      for (const char* const key : {"format", "verdicts"})
        if (document_.find(key) == nullptr) refuse(std::string("/") + key, "is missing");
    }
    if (!faults_.empty()) throw Failure(ExitCode::bad_input, faults_);
    return std::move(expected_);
  }

 private:
  void refuse(const std::string& place, const std::string& rule) {
    faults_ += (faults_.empty() ? "" : "\n") + expected_.path + ": " + place + ": " + rule;
  }

  void read_member(const std::string& key, const Json& value) {
    if (key == "verdicts") return read_verdicts(value);
    if (key != "format") return refuse("/" + key, unknown_word("key", key, {"format", "verdicts"}));
    const std::string* const format = value.get<std::string>();
    if (format == nullptr || *format != kFormat)
      refuse("/format", "must be \"" + std::string(kFormat) + "\" (found " + to_text(value) + ")");
  }

  void read_verdicts(const Json& value) {
    const Json::Object* const verdicts = value.get<Json::Object>();
    if (verdicts == nullptr) return refuse("/verdicts", "must be an object with a verdict for each name");
    std::set<std::string> names;
    for (const auto& [name, verdict] : *verdicts) {
      const std::string* const text = verdict.get<std::string>();
      if (!names.insert(name).second)
        refuse(pointer_to("/verdicts", name), "duplicate key");
      else if (text == nullptr)
        refuse(pointer_to("/verdicts", name), "must be a text (found " + to_text(verdict) + ")");
      else
        expected_.verdicts.emplace_back(name, *text);
    }
  }

  ExpectedVerdicts expected_;
  Json document_;
  std::string faults_;
};

}  // namespace

ExpectedVerdicts read_expected_verdicts(const std::string& path) { return Reader(path).read(); }

}  // namespace hyrax
