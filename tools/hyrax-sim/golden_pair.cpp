#include "tools/hyrax-sim/golden_pair.h"

#include "tools/files/text_file.h"
#include "tools/hyrax-sim/margin_text.h"
#include "tools/store/golden_file.h"
#include "tools/store/golden_summary.h"

namespace hyrax {
namespace {

std::string summary_text(const FreshRun& fresh, const std::string& reason, const GoldenChecksums& checksums) {
  return golden_summary_text(fresh.run, fresh.summary, reason, margin_in_summary(fresh), checksums);
}

// What in a pair whose rows agree is not as it was blessed. Two scenarios may differ in name and in how they
// are written and be the same all the same, so both are taken from the .h5 file.
std::optional<std::string> fault_in(const std::string& text, const StoredRun& kept, FreshRun fresh,
                                    const std::string& h5_checksum, const GoldenPlace& place) {
  fresh.run.scenario.name = kept.scenario.name;
  const GoldenChecksums checksums{contents_checksum(kept), h5_checksum};
  if (const auto fault = summary_difference(text, summary_text(fresh, summary_reason(text), checksums)))
    return place.txt_path + ": " + *fault;
  return attribute_difference(place.h5_path, kept);
}

void refuse_pair(Comparison& comparison, const std::string& fault) {
  comparison.agrees = false;
  comparison.difference = DifferenceClass::shape;
  comparison.shape = "all rows agree, but the golden file was changed after it was blessed: " + fault +
                     "; restore it, or bless the scenario again";
}

PairComparison read_and_compare(const Scenario& scenario, const GoldenPlace& place, const std::string& text,
                                FreshRun fresh, const std::string& h5_checksum) {
  const StoredRun kept = read_golden(place.h5_path);
  ComparedRun compared = compare_with(kept, scenario);
  PairComparison pair{std::move(compared.comparison), compared.summary, false, ""};
  if (!pair.comparison.agrees) return pair;
  const std::string blessed_checksum = summary_file_checksum(text).value_or(h5_checksum);
  if (const auto fault = fault_in(text, kept, std::move(fresh), blessed_checksum, place))
    refuse_pair(pair.comparison, *fault);
  else if (blessed_checksum != h5_checksum)
    pair.note = place.h5_path + ": agrees, but does not have the checksum in " + place.txt_path +
                ": its provenance or its layout differs";
  return pair;
}

}  // namespace

std::string summary_of(const FreshRun& fresh, const std::string& reason, const std::string& h5_checksum) {
  return summary_text(fresh, reason, {contents_checksum(fresh.run), h5_checksum});
}

std::optional<PairComparison> compare_with_pair(const Scenario& scenario, const GoldenPlace& place,
                                                bool reads_h5) {
  const std::string text = read_text_file(place.txt_path);
  const std::string h5_checksum = file_checksum(place.h5_path);
  FreshRun fresh = play_for_golden(scenario);
  if (text == summary_of(fresh, summary_reason(text), h5_checksum))
    return PairComparison{.summary = fresh.summary};
  if (!reads_h5) return std::nullopt;
  return read_and_compare(scenario, place, text, std::move(fresh), h5_checksum);
}

bool is_h5_current(const Scenario& scenario, const GoldenPlace& place) {
  const StoredRun kept = read_golden(place.h5_path);
  return kept.scenario.name == scenario.name && compare_with(kept, scenario).comparison.agrees &&
         !attribute_difference(place.h5_path, kept);
}

}  // namespace hyrax
