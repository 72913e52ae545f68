#include "tools/app/clock/new_scenario.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

#include "sim/result/number_text.h"
#include "sim/scenario/scenario.h"
#include "tools/files/failure.h"
#include "tools/files/printable.h"
#include "tools/files/text_file.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

// The records of a CSV file by RFC 4180; line ends are LF or CRLF, a byte-order mark is skipped. By hand: a
// message names the line and column of a misplaced quote, which Debian's libcsv does not say.
class CsvReader {
 public:
  CsvReader(const std::string& path, std::string_view text) : path_(path), rest_(text) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
  }

  [[nodiscard]] bool starts_with(std::string_view text) const { return rest_.starts_with(text); }
  /// Whether the last record ended without a line end, as a file that was cut off does.
  [[nodiscard]] bool is_cut_off() const { return is_cut_off_; }
  void skip_line() {
    rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size() - 1) + 1);
    line_ = next_line_++;
  }

  // The next record's fields; nothing at the end of the file, blank lines there are skipped. ERRORS:
  // Failure(bad_input) for a misplaced quote.
  std::optional<std::vector<std::string>> next() {
    if (rest_.find_first_not_of("\r\n") == rest_.npos) return std::nullopt;
    line_ = next_line_++;
    std::vector<std::string> fields;
    do
      fields.push_back(rest_.starts_with('"') ? quoted_field(fields.size() + 1)
                                              : plain_field(fields.size() + 1));
    while (take(","));
    is_cut_off_ = !take("\r\n") && !take("\n");
    return fields;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    refuse_input(fmt::format("{}: line {}{}", path_, line_, what));
  }

 private:
  bool take(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }

  bool is_at_end() const {
    return rest_.empty() || rest_[0] == ',' || rest_[0] == '\n' || rest_.starts_with("\r\n");
  }

  std::string plain_field(std::size_t column) {
    std::string field;
    for (; !is_at_end(); rest_.remove_prefix(1)) {
      if (rest_[0] == '"') refuse(fmt::format(", column {}: quote inside a field without quotes", column));
      field += rest_[0];
    }
    return field;
  }

  std::string quoted_field(std::size_t column) {
    std::string field;
    for (rest_.remove_prefix(1); !take("\"") || rest_.starts_with('"'); rest_.remove_prefix(1)) {
      if (rest_.empty()) refuse(fmt::format(", column {}: closing quote is missing", column));
      if (rest_[0] == '\n') ++next_line_;
      field += rest_[0];
    }
    if (!is_at_end())
      refuse(fmt::format(", column {}: text after the closing quote (found {})", column, rest_[0]));
    return field;
  }

  const std::string& path_;
  std::string_view rest_;
  std::size_t line_ = 1;
  std::size_t next_line_ = 1;
  bool is_cut_off_ = false;
};

// Without case and blanks.
std::string plain(std::string_view name) {
  std::string text;
  for (const char c : name)
    if (std::isspace(static_cast<unsigned char>(c)) == 0)
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

using Record = std::vector<std::string>;

std::optional<std::size_t> find_column(const CsvReader& csv, const Record& header, std::string_view name) {
  std::optional<std::size_t> found;
  for (std::size_t column = 0; column < header.size(); ++column) {
    if (plain(header[column]) != plain(name)) continue;
    if (found) csv.refuse(fmt::format(": duplicate column (found {})", header[column]));
    found = column;
  }
  return found;
}

constexpr std::array<std::string_view, 2> kPresentMonColumns = {"MsBetweenPresents", "FrameTime"};

bool is_presentmon(std::string_view column) {
  return plain(column) == plain(kPresentMonColumns[0]) || plain(column) == plain(kPresentMonColumns[1]);
}

std::size_t times_column(const CsvReader& csv, const Record& header, const std::string& name) {
  if (name.empty()) {
    for (const std::string_view presentmon : kPresentMonColumns)
      if (const auto column = find_column(csv, header, presentmon)) return *column;
    csv.refuse(fmt::format(": column is missing: {} (found {}); --column names another",
                           fmt::join(kPresentMonColumns, " or "),
                           shortened(listed(std::vector<std::string_view>(header.begin(), header.end())))));
  }
  if (const auto column = find_column(csv, header, name)) return *column;
  csv.refuse(": " + unknown_word("column", name, {header.begin(), header.end()}));
}

constexpr const char* kSaveWithCommas = "save it with commas between columns and decimal points";

// The line with the columns' names: comment lines (CapFrameX), and two lines about the machine (MangoHud) may
// come first.
Record read_header(CsvReader& csv) {
  if (csv.starts_with("sep="))
    csv.refuse(fmt::format(": begins with sep=, as Excel writes it; {}, without this line", kSaveWithCommas));
  while (csv.starts_with("//") || csv.starts_with("#")) csv.skip_line();
  Record header = csv.next().value_or(Record{});
  if (header.size() > 1 && plain(header[0]) == "os" && plain(header[1]) == "cpu") {
    csv.skip_line();
    header = csv.next().value_or(Record{});
  }
  for (const auto& [separator, name] : {std::pair(';', "semicolons"), {'\t', "tabs"}}) {
    std::ptrdiff_t found = 0;
    for (const std::string& field : header) found += std::ranges::count(field, separator);
    if (found > 0 && found >= std::ssize(header))
      csv.refuse(fmt::format(": its columns are separated by {}; {}", name, kSaveWithCommas));
  }
  return header;
}

// How many units of the column are a second.
double units_in(const std::string& unit) { return unit == "s" ? 1.0 : unit == "ms" ? 1e3 : 1e6; }

// A column fps beside it says which unit it has: in MangoHud's logs ms or us, by its version.
std::string unit_by_rate(CsvReader csv, std::size_t times, std::size_t rates) {
  double tens = 0.0, count = 0.0;
  while (const auto record = csv.next()) {
    double time = 0.0, rate = 0.0;
    const auto read = [&](std::size_t column, double& number) {
      if (column >= record->size()) return false;
      const std::string& field = (*record)[column];
      return std::from_chars(field.data(), field.data() + field.size(), number).ec == std::errc() &&
             number > 0.0;
    };
    if (!read(times, time) || !read(rates, rate)) continue;
    tens += std::log10(time * rate);
    count += 1.0;
  }
  const double tens_per_s = count > 0.0 ? tens / count : 3.0;
  return tens_per_s < 1.5 ? "s" : tens_per_s < 4.5 ? "ms" : "us";
}

double read_time(const CsvReader& csv, const std::string& field, const std::string& place,
                 double units_per_s) {
  double value = -1.0;
  const char* const end = field.data() + field.size();
  const auto [rest, error] = std::from_chars(field.data(), end, value);
  const double dt_s = value / units_per_s;
  if (error != std::errc() || rest != end || !(dt_s >= 0.0 && dt_s <= kFrameMax_s))
    csv.refuse(fmt::format(", {}: must be a number 0 .. {} (found {}){}", place, kFrameMax_s * units_per_s,
                           field.substr(0, 60),
                           field.find(',') == field.npos ? "" : "; write a decimal point"));
  return dt_s;
}

// Displays show 24 to 1,000 frames a second; stalls are few.
std::string doubt_of(std::vector<double> dt_s, const std::string& unit) {
  constexpr double kLong_s = 1.0;
  constexpr double kShort_s = 1e-4;
  const auto middle = dt_s.begin() + std::ssize(dt_s) / 2;
  std::ranges::nth_element(dt_s, middle);
  if (*middle < kLong_s && *middle >= kShort_s) return "";
  return fmt::format(
      "half of the frames take {} s or {} (read in {}); is that the column's unit? --unit s|ms sets it",
      *middle, *middle < kShort_s ? "less" : "more", unit);
}

// Of several programs, windows and displays PresentMon records all frames into one file.
class Sources {
 public:
  Sources(const CsvReader& csv, const Record& header, const FrameTimesRequest& request)
      : keys_{{{"Application", "application", "--application", request.application, {}},
               {"ProcessID", "process", "--process", request.process, {}},
               {"SwapChainAddress", "swap chain", "--swap-chain", request.swap_chain, {}}}} {
    for (Key& key : keys_) {
      key.column = find_column(csv, header, key.name);
      if (!key.wanted.empty() && !key.column)
        csv.refuse(fmt::format(": {}: the file has no column {}", key.option, key.name));
    }
  }

  // Whether the frame is one of those that are wanted.
  bool takes(const Record& record) {
    bool is_wanted = true;
    Record source;
    for (const Key& key : keys_) {
      source.push_back(key.column ? record[*key.column] : "");
      is_wanted = is_wanted && (key.wanted.empty() || plain(key.wanted) == plain(source.back()));
    }
    ++(is_wanted ? taken_ : others_)[source];
    return is_wanted;
  }

  [[nodiscard]] std::size_t last_column() const {
    std::size_t last = 0;
    for (const Key& key : keys_) last = std::max(last, key.column.value_or(0));
    return last;
  }

  void require_one(const std::string& path) const {
    if (taken_.size() == 1) return;
    std::vector<std::string> options;
    for (std::size_t key = 0; key < keys_.size(); ++key)
      if (std::ranges::any_of(
              taken_, [&](const auto& each) { return each.first[key] != taken_.begin()->first[key]; }))
        options.push_back(std::string(keys_[key].option));
    refuse_input(taken_.empty() ? fmt::format("{}: no such frame; found: {}", path, list(others_))
                                : fmt::format("{}: frames of several sources: {}; pick one with {}", path,
                                              list(taken_), fmt::join(options, " or ")));
  }

 private:
  struct Key {
    std::string_view name;  // Of the column.
    std::string_view shown;
    std::string_view option;
    std::string wanted;
    std::optional<std::size_t> column;
  };
  using Frames = std::map<Record, std::int64_t>;

  [[nodiscard]] std::string list(const Frames& all) const {
    constexpr std::size_t kListedMax = 20;
    std::vector<std::string> texts;
    for (const auto& [source, frames] : all) {
      if (texts.size() == kListedMax) {
        texts.push_back(fmt::format("and {} more", all.size() - kListedMax));
        break;
      }
      std::string text;
      for (std::size_t key = 0; key < keys_.size(); ++key)
        if (keys_[key].column) text += fmt::format("{} {}, ", keys_[key].shown, shortened(source[key]));
      texts.push_back(text + plain_counted(frames, "frame"));
    }
    return fmt::format("{}", fmt::join(texts, "; "));
  }

  std::array<Key, 3> keys_;
  Frames taken_;
  Frames others_;
};

}  // namespace

FrameTimes read_frame_times(const FrameTimesRequest& request) {
  if (request.unit.empty() && !request.column.empty() && !is_presentmon(request.column))
    refuse_input("hyrax-sim new: --unit: is missing; needed with --column " + request.column);
  const std::string text = read_text_file(request.path);
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
      text.substr(0, 4).find('\0') != text.npos)
    refuse_input(request.path + ": is UTF-16; save it as UTF-8");
  CsvReader csv(request.path, text);
  const Record header = read_header(csv);
  const std::size_t column = times_column(csv, header, request.column);
  const std::string place = fmt::format("column {} ({})", column + 1, header[column]);
  FrameTimes frames;
  frames.unit = request.unit.empty() ? "ms" : request.unit;
  if (const auto rates = find_column(csv, header, "fps"); rates && request.unit.empty())
    frames.unit = unit_by_rate(csv, column, *rates);
  // Version 1 of PresentMon has a column for it; in version 2 a dropped frame has no time on the display.
  auto dropped_column = find_column(csv, header, "Dropped");
  const std::string_view when_dropped = dropped_column ? "1" : "na";
  for (const char* const name : {"DisplayedTime", "MsUntilDisplayed"})
    if (!dropped_column) dropped_column = find_column(csv, header, name);
  if (dropped_column) frames.dropped = 0;
  const auto type_column = find_column(csv, header, "FrameType");
  if (type_column) frames.left_out = 0;
  Sources sources(csv, header, request);
  const std::size_t fields_least =
      1 + std::max({column, dropped_column.value_or(0), type_column.value_or(0), sources.last_column()});
  bool has_frames = false;
  std::optional<Failure> bad_value;  // Reported once the frames are known to be of one source.
  while (const auto record = csv.next()) {
    has_frames = true;
    // OCAT's header has columns that only its first row fills.
    const bool is_cut = record->size() < header.size() && record->size() == fields_least && csv.is_cut_off();
    if (record->size() > header.size() || record->size() < fields_least || is_cut)
      csv.refuse(
          fmt::format(": must have {} fields, as the header (found {}){}", header.size(), record->size(),
                      record->size() > header.size() ? "; a decimal comma separates fields, too" : ""));
    if (!sources.takes(*record)) continue;
    if (type_column && plain((*record)[*type_column]) != "application") {
      ++*frames.left_out;
      continue;
    }
    if (bad_value) continue;
    try {
      frames.dt_s.push_back(read_time(csv, (*record)[column], place, units_in(frames.unit)));
    } catch (const Failure& failure) {
      bad_value = failure;
    }
    if (dropped_column && plain((*record)[*dropped_column]) == when_dropped) ++*frames.dropped;
  }
  if (!has_frames) csv.refuse(": no frame after the header");
  sources.require_one(request.path);
  if (bad_value) throw *bad_value;
  if (frames.dt_s.empty())
    refuse_input(fmt::format("{}: no frame of FrameType Application (left out: {} others)", request.path,
                             *frames.left_out));
  frames.doubt = doubt_of(frames.dt_s, frames.unit);
  return frames;
}

}  // namespace hyrax
