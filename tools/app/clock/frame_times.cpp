#include "tools/app/clock/frame_times.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
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
    if (!take("\r\n")) static_cast<void>(take("\n"));
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

double read_dt_s(const CsvReader& csv, const std::string& field, const std::string& place, double unit) {
  double value = -1.0;
  const char* const end = field.data() + field.size();
  const auto [rest, error] = std::from_chars(field.data(), end, value);
  const double dt_s = value / unit;
  if (error != std::errc() || rest != end || !(dt_s >= 0.0 && dt_s <= kFrameMax_s))
    csv.refuse(fmt::format(", {}: must be a number 0 .. {} (found {})", place, kFrameMax_s * unit,
                           field.substr(0, 60)));
  return dt_s;
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
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    refuse_input(request.path + ": is UTF-16; save it as UTF-8");
  CsvReader csv(request.path, text);
  const Record header = csv.next().value_or(Record{});
  const std::size_t column = times_column(csv, header, request.column);
  const std::string place = fmt::format("column {} ({})", column + 1, header[column]);
  // Version 1 of PresentMon has a column for it; version 2 has no time on the display.
  auto dropped_column = find_column(csv, header, "Dropped");
  const std::string_view when_dropped = dropped_column ? "1" : "na";
  if (!dropped_column) dropped_column = find_column(csv, header, "DisplayedTime");
  Sources sources(csv, header, request);
  FrameTimes frames;
  if (dropped_column) frames.dropped = 0;
  bool has_frames = false;
  std::optional<Failure> bad_value;  // Reported once the frames are known to be of one source.
  while (const auto record = csv.next()) {
    has_frames = true;
    if (record->size() != header.size())
      csv.refuse(
          fmt::format(": must have {} fields, as the header (found {})", header.size(), record->size()));
    if (!sources.takes(*record) || bad_value) continue;
    try {
      frames.dt_s.push_back(read_dt_s(csv, (*record)[column], place, request.unit == "s" ? 1.0 : 1000.0));
    } catch (const Failure& failure) {
      bad_value = failure;
    }
    if (dropped_column && plain((*record)[*dropped_column]) == when_dropped) ++*frames.dropped;
  }
  if (!has_frames) csv.refuse(": no frame after the header");
  sources.require_one(request.path);
  if (bad_value) throw *bad_value;
  return frames;
}

}  // namespace hyrax
