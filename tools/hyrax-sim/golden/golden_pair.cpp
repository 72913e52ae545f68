#include "tools/hyrax-sim/golden/golden_pair.h"

#include "tools/files/text_file.h"
#include "tools/hyrax-sim/drift/margin_text.h"
#include "tools/store/golden_digest.h"
#include "tools/store/golden_file.h"
#include "tools/store/golden_seal.h"

namespace hyrax {
namespace {

std::string sealed_summary(const FreshRun& fresh, const std::string& reason, const GoldenSeal& seal) {
  return golden_digest_text(fresh.run, fresh.summary, reason, margin_in_summary(fresh)) + seal_line(seal);
}

// What in a pair whose rows agree is not as it was blessed. Two scenarios may differ in name and in how they
// are written and be the same all the same, so both are taken from the .h5 file.
std::optional<std::string> fault_in(const std::string& text, const StoredRun& kept, FreshRun fresh,
                                    const std::string& sealed_hash, const GoldenPlace& place) {
  fresh.run.scenario.name = kept.scenario.name;
  const GoldenSeal seal{contents_hash(kept), sealed_hash};
  if (const auto fault = digest_fault(text, sealed_summary(fresh, digest_reason(text), seal)))
    return place.txt_path + ": " + *fault;
  return golden_words_fault(place.h5_path);
}

void refuse_pair(Comparison& comparison, const std::string& fault) {
  comparison.agrees = false;
  comparison.difference = DifferenceClass::shape;
  comparison.shape = "all rows agree, but the golden file was changed after it was blessed: " + fault +
                     "; restore it, or bless the scenario again";
}

PairComparison read_and_compare(const Scenario& scenario, const GoldenPlace& place, const std::string& text,
                                FreshRun fresh, const std::string& h5_hash) {
  const StoredRun kept = read_golden(place.h5_path);
  ComparedRun compared = compare_with(kept, scenario);
  PairComparison pair{std::move(compared.comparison), compared.summary, false, ""};
  if (!pair.comparison.agrees) return pair;
  const auto seal = seal_in(text);
  const std::string sealed_hash = seal ? seal->file : h5_hash;
  if (const auto fault = fault_in(text, kept, std::move(fresh), sealed_hash, place))
    refuse_pair(pair.comparison, *fault);
  else if (sealed_hash != h5_hash)
    pair.note = place.h5_path + ": agrees, but its bytes are not those that " + place.txt_path +
                " seals: its provenance or its layout is another";
  return pair;
}

}  // namespace

std::string summary_of(const FreshRun& fresh, const std::string& reason, const std::string& h5_hash) {
  return sealed_summary(fresh, reason, {contents_hash(fresh.run), h5_hash});
}

std::optional<PairComparison> compare_with_pair(const Scenario& scenario, const GoldenPlace& place,
                                                bool reads_h5) {
  const std::string text = read_text_file(place.txt_path);
  const std::string h5_hash = file_hash(place.h5_path);
  FreshRun fresh = play_for_golden(scenario);
  if (text == summary_of(fresh, digest_reason(text), h5_hash))
    return PairComparison{.summary = fresh.summary};
  if (!reads_h5) return std::nullopt;
  return read_and_compare(scenario, place, text, std::move(fresh), h5_hash);
}

bool is_h5_current(const Scenario& scenario, const GoldenPlace& place) {
  const StoredRun kept = read_golden(place.h5_path);
  return kept.scenario.name == scenario.name && compare_with(kept, scenario).comparison.agrees &&
         !golden_words_fault(place.h5_path);
}

}  // namespace hyrax
