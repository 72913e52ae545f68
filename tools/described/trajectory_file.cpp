#include "tools/described/trajectory_file.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <span>

#include "tools/described/scenario_json.h"
#include "tools/described/value_json.h"
#include "tools/files/failure.h"
#include "tools/store/isolated_read.h"
#include "tools/store/trajectory_parts.h"
#include "tools/store/trajectory_writer.h"

namespace hyrax {
namespace {

constexpr std::size_t kBatchRows = 4096;

const ValueInfo kStep{.name = "step", .type = ValueType::int64};
const ValueInfo kLastStep{.name = "last_step", .type = ValueType::int64};
const ValueInfo kTime{.name = "t", .unit = "s"};
const ValueInfo kFrameTime{.name = "dt", .unit = "s"};
const ValueInfo kIsHeld{.name = "is_held", .type = ValueType::boolean};

ValueInfo contact_codes(const Description& description) {
  const bool are_bytes = description.contacts.size() <= std::numeric_limits<std::uint8_t>::max();
  return {.name = "contact",
          .type = are_bytes ? ValueType::uint8 : ValueType::uint16,
          .names = description.contacts};
}

ValueInfo flag_of(const std::string& contact) { return {.name = contact, .type = ValueType::boolean}; }

bool is_recorded(std::int64_t step, std::int64_t every, std::int64_t steps) {
  return step % every == 0 || step == steps;
}

// The first value in px, else the first.
const std::string& signal_of(const Description& description) {
  const auto& values = description.state.values;
  const auto found = std::ranges::find(values, "px", &ValueInfo::unit);
  return (found == values.end() ? values.front() : *found).name;
}

std::size_t bytes_of(const ValueInfo& value) {
  return visit_stored(value.type, [](auto number) { return sizeof number; });
}

}  // namespace

// Datasets of one length, written row by row.
class ValueTable {
 public:
  ValueTable(hid_t parent, const char* name, std::int64_t rows)
      : group_(h5::create_group(parent, name)), rows_(rows) {}

  void add(const ValueInfo& value, const std::string& long_name) {
    Column& column = columns_.emplace_back();
    column.type = value.type;
    if (!value.names.empty()) column.names = h5::enum_type(value.type, value.names);
    column.dataset = h5::create_dataset(group_, value.name.c_str(),
                                        value.names.empty() ? h5::file_type(value.type) : hid_t{column.names},
                                        {static_cast<hsize_t>(rows_)});
    if (!value.unit.empty()) h5::write_attribute(column.dataset, "units", value.unit);
    h5::write_attribute(column.dataset, "long_name", long_name);
  }
  // The next value of a row, in the order of the columns.
  void put(Word word) {
    Column& column = columns_[next_];
    visit_stored(column.type, [&](auto number) {
      number = value_of<decltype(number)>(word);
      const auto bytes = std::as_bytes(std::span(&number, 1));
      column.pending.insert(column.pending.end(), bytes.begin(), bytes.end());
    });
    if (++next_ < columns_.size()) return;
    next_ = 0;
    if (++pending_ == kBatchRows) write();
  }
  void put_all(std::span<const Word> words) {
    for (const Word word : words) put(word);
  }

  [[nodiscard]] hid_t group() const { return group_; }
  [[nodiscard]] bool is_written() const { return is_written_; }
  /// @param axis of the datasets.
  [[nodiscard]] bool finish(const char* axis) {
    write();
    const bool is_complete = is_written_ && written_ == rows_ && h5::share_axis(group_, axis);
    columns_.clear();
    return is_complete;
  }

 private:
  struct Column {
    ValueType type = ValueType::float64;
    h5::Handle names = {};  // Their type.
    h5::Handle dataset = {};
    std::vector<std::byte> pending = {};
  };

  void write() {
    for (Column& column : columns_) {
      const hid_t type =
          column.names.is_open()
              ? hid_t{column.names}
              : visit_stored(column.type, [](auto number) { return h5::native_type<decltype(number)>(); });
      if (pending_ > 0)
        is_written_ = is_written_ && column.dataset.is_open() &&
                      h5::write_rows(column.dataset, type, static_cast<hsize_t>(written_), pending_,
                                     column.pending.data()) >= 0;
      column.pending.clear();
    }
    written_ += static_cast<std::int64_t>(pending_);
    pending_ = 0;
  }

  h5::Handle group_;
  std::int64_t rows_;
  std::int64_t written_ = 0;
  std::size_t pending_ = 0;  // Rows.
  std::size_t next_ = 0;     // Column.
  bool is_written_ = true;
  std::vector<Column> columns_;
};

namespace {

bool write_contacts(hid_t file, const Description& description, std::vector<DescribedContact> contacts,
                    std::int64_t total) {
  std::ranges::sort(contacts, {}, [](const DescribedContact& contact) { return order_of(contact); });
  ValueTable table(file, "contacts", std::ssize(contacts));
  table.add(kStep, "row number of the first row");
  table.add(kLastStep, "row number of the last row");
  table.add(contact_codes(description), "which contact");
  table.add(kTime, "time of the first row");
  for (const DescribedContact& contact : contacts)
    table.put_all(std::array{word_of(contact.step), word_of(contact.last_step), Word{contact.contact},
                             word_of(contact.t_s)});
  h5::write_attribute(table.group(), "total", total);
  return table.finish("step");
}

bool write_events(hid_t file, const DescribedHead& head) {
  const std::vector<TimedEvent> events = timed_events(head.scenario, head.steps);
  const h5::Handle group = h5::create_group(file, "events");
  return h5::write_columns(
      group,
      {column_of("frame", "", "frame to which the event was applied; it makes row frame + 1", events,
                 &TimedEvent::frame),
       column_of(
           "event", "", "the event as in a scenario, without its time", events,
           [&](const TimedEvent& event) { return to_text(event_json(head.description, *event.action)); })},
      "frame");
}

// The state at each block's first row is in /trajectory.
bool write_blocks(hid_t file, const Description& description, const std::vector<DescribedBlock>& blocks) {
  ValueTable table(file, "blocks", std::ssize(blocks));
  Codes digests;
  table.add(kStep, "row number of the first row");
  visit_timeline(blocks.front().keyframe.timeline, [&](const char* name, auto number) {
    table.add({.name = name, .type = value_type<decltype(number)>()}, "time of that row, as it goes on");
  });
  table.add(kIsHeld, "whether frames pass without a step");
  ValueTable inputs(table.group(), "inputs", std::ssize(blocks));
  inputs.add(kStep, "row number");
  for (const ValueInfo& input : description.inputs.values) inputs.add(input, input.name);
  for (const DescribedBlock& block : blocks) {
    digests.codes.insert(digests.codes.end(), block.digest.begin(), block.digest.end());
    table.put(word_of(block.keyframe.step));
    visit_timeline(block.keyframe.timeline, [&](const char*, auto number) { table.put(word_of(number)); });
    table.put(word_of(block.keyframe.is_held));
    inputs.put(word_of(block.keyframe.step));
    inputs.put_all(block.keyframe.inputs);
  }
  const Column digest{.name = "digest", .long_name = "", .values = std::move(digests)};
  return h5::ColumnWriter(table.group(), {digest}, length(digest)).append({digest}) &&
         inputs.finish("step") && table.finish("step");
}

}  // namespace

DescribedWriter::DescribedWriter(const std::string& part_path, const std::string& path,
                                 const Description& description, std::int64_t steps, std::int64_t every)
    : path_(path), description_(description), steps_(steps), every_(every) {
  std::vector<std::pair<ValueInfo, std::string>> columns = {
      {kStep, "row number"}, {kTime, "time"}, {kFrameTime, "time step that led to this row"}};
  for (const ValueInfo& value : description.state.values) columns.emplace_back(value, value.name);
  for (const std::string& contact : description.contacts) columns.emplace_back(flag_of(contact), contact);
  for (const ValueInfo& value : description.outputs.values) columns.emplace_back(value, value.name);
  std::uint64_t row_bytes = 0;
  for (const auto& [value, long_name] : columns) row_bytes += bytes_of(value);
  const std::int64_t rows = TrajectoryWriter::row_count(steps, every);
  file_ = h5::create_file(part_path, require_disk_space(path, rows, row_bytes));
  require_written(file_.is_open(), path_);
  rows_ = std::make_unique<ValueTable>(file_, "trajectory", rows);
  for (const auto& [value, long_name] : columns) rows_->add(value, long_name);
}

DescribedWriter::~DescribedWriter() = default;

void DescribedWriter::row(const DescribedRow& row) {
  if (!is_recorded(row.step, every_, steps_)) return;
  rows_->put(word_of(row.step));
  rows_->put(word_of(row.t_s));
  rows_->put(word_of(row.dt_s));
  rows_->put_all(row.state);
  for (const std::uint8_t flag : row.contacts) rows_->put(flag);
  rows_->put_all(row.outputs);
  require_written(rows_->is_written(), path_);
}

void DescribedWriter::finish(const DescribedHead& head, std::int64_t contacts_total,
                             const std::vector<DescribedBlock>& blocks) {
  const hid_t group = rows_->group();
  h5::write_attribute(group, "NX_class", "NXdata");
  h5::write_attribute(group, "signal", signal_of(description_));
  h5::write_attribute(group, "axes", "t");
  require_written(rows_->finish("t"), path_);
  require_written(write_contacts(file_, description_, std::move(contacts_), contacts_total), path_);
  require_written(blocks.empty() || write_blocks(file_, description_, blocks), path_);
  write_root(file_, head, head.scenario.name, to_text(to_json(description_, head.scenario)));
  h5::write_attribute(file_, "core_name", description_.core);
  h5::write_attribute(file_, "description", to_text(description_json(description_)));
  require_written(write_events(file_, head), path_);
  rows_.reset();
  require_written(file_.close() >= 0, path_);
}

DescribedCsv::DescribedCsv(const std::string& path, const Description& description, std::int64_t steps,
                           std::int64_t every)
    : description_(description),
      steps_(steps),
      every_(every),
      file_(path, TrajectoryWriter::row_count(steps, every),
            3 + description.state.values.size() + description.contacts.size() +
                description.outputs.values.size()) {
  std::string head = "step,t_s,dt_s";
  for (const ValueInfo& value : description.state.values) head += "," + value.name;
  for (const std::string& contact : description.contacts) head += "," + contact;
  for (const ValueInfo& value : description.outputs.values) head += "," + value.name;
  file_.append(head + "\n");
}

void DescribedCsv::row(const DescribedRow& row) {
  if (!is_recorded(row.step, every_, steps_)) return;
  std::string line;
  const auto add = [&](ValueType type, Word word) {
    visit_stored(type, [&](auto number) {
      char text[32];
      number = value_of<decltype(number)>(word);
      line.append(line.empty() ? "" : ",").append(text, std::to_chars(text, text + sizeof text, number).ptr);
    });
  };
  add(ValueType::int64, word_of(row.step));
  add(ValueType::float64, word_of(row.t_s));
  add(ValueType::float64, word_of(row.dt_s));
  for (std::size_t index = 0; index < row.state.size(); ++index)
    add(description_.state.values[index].type, row.state[index]);
  for (const std::uint8_t flag : row.contacts) add(ValueType::boolean, flag);
  for (std::size_t index = 0; index < row.outputs.size(); ++index)
    add(description_.outputs.values[index].type, row.outputs[index]);
  file_.append(line + "\n");
}

DescribedFile::DescribedFile(const std::string& path, const std::string& core, Parsing parsing)
    : RunFile(path),
      head_(read_head(core, parsing)),
      t_(file_, path, "/trajectory/t"),
      dt_(file_, path, "/trajectory/dt") {
  require_rows(t_.length(), "t");
  require_rows(dt_.length(), "dt");
  const auto add = [&](std::vector<ValueColumn>& columns, const ValueInfo& value) {
    columns.push_back(value_column("/trajectory/" + value.name, value));
    require_rows(columns.back().length, value.name);
  };
  for (const ValueInfo& value : head_.description.state.values) add(state_, value);
  for (const ValueInfo& value : head_.description.outputs.values) add(outputs_, value);
  for (const std::string& contact : head_.description.contacts) add(flags_, flag_of(contact));
  if (row_count() == 0) refuse("/trajectory: has no rows");
}

DescribedFile DescribedFile::open(const std::string& path, const std::string& core) {
  read_isolated(path, [&] { DescribedFile(path, core, Parsing::off).read_all(); });
  return {path, core, Parsing::on};
}

DescribedHead DescribedFile::read_head(const std::string& core, Parsing parsing) const {
  if (root_.physics != kDescribedModel)
    refuse("is of a core of the paper's interface (" + root_.physics +
           "): read it with hyrax-sim, or with the program of that core");
  if (const std::string name = text("core_name"); name != core)
    refuse("is of the core " + name + ": read it with " + name + "-sim");
  DescribedHead head{root_, {}, {}};
  head.description = parse_description(text("description"), core, path() + ": attribute description");
  if (head.description.state.values.empty()) refuse("attribute description: has no state");
  if (parsing == Parsing::on)
    head.scenario =
        parse_described_scenario(head.description, text("scenario"), path() + ": attribute scenario");
  return head;
}

DescribedFile::ValueColumn DescribedFile::value_column(const std::string& dataset,
                                                       const ValueInfo& value) const {
  return visit_stored(value.type, [&](auto number) -> ValueColumn {
    using Number = decltype(number);
    const H5T_class_t type_class = !value.names.empty()               ? H5T_ENUM
                                   : std::is_floating_point_v<Number> ? H5T_FLOAT
                                                                      : H5T_INTEGER;
    const auto numbers = std::make_shared<NumberColumn<Number>>(file_, path(), dataset, type_class);
    return {numbers->length(), [numbers](std::int64_t first, std::int64_t count, std::vector<Word>& words) {
              std::vector<Number> values;
              numbers->read(first, count, values);
              words.resize(values.size());
              std::ranges::transform(values, words.begin(), [](Number each) { return word_of(each); });
            }};
  });
}

std::vector<Word> DescribedFile::words(const std::string& dataset, const ValueInfo& value,
                                       std::size_t length) const {
  const ValueColumn values = value_column(dataset, value);
  if (values.length != static_cast<std::int64_t>(length)) refuse(dataset + ": has the wrong length");
  std::vector<Word> words;
  values.read(0, values.length, words);
  return words;
}

DescribedRowBatches DescribedFile::rows() const {
  return [this, first = std::int64_t{0}](DescribedRows& batch) mutable {
    batch = {};
    const std::int64_t count = std::min<std::int64_t>(kBatchRows, row_count() - first);
    step_.read(first, count, batch.step);
    t_.read(first, count, batch.t_s);
    dt_.read(first, count, batch.dt_s);
    const auto rows = static_cast<std::size_t>(count);
    std::vector<Word> words;
    const auto put = [&](const std::vector<ValueColumn>& columns, auto& values) {
      values.resize(rows * columns.size());
      for (std::size_t column = 0; column < columns.size(); ++column) {
        columns[column].read(first, count, words);
        for (std::size_t row = 0; row < rows; ++row)
          values[row * columns.size() + column] =
              static_cast<std::ranges::range_value_t<decltype(values)>>(words[row]);
      }
    };
    put(state_, batch.state);
    put(flags_, batch.contacts);
    first += count;
  };
}

void DescribedFile::show(DescribedSink& sink) const {
  std::int64_t first = 0;
  const DescribedRowBatches batches = rows();
  DescribedRows batch;
  for (batches(batch); batch.size() > 0; batches(batch)) {
    std::vector<std::vector<Word>> columns(outputs_.size());
    for (std::size_t column = 0; column < outputs_.size(); ++column)
      outputs_[column].read(first, std::ssize(batch.step), columns[column]);
    std::vector<Word> outputs(outputs_.size());
    for (std::size_t index = 0; index < batch.size(); ++index) {
      const KeptRow row = batch.row(index);
      std::ranges::transform(columns, outputs.begin(),
                             [index](const std::vector<Word>& column) { return column[index]; });
      sink.row({row.step, row.t_s, row.dt_s, row.state, outputs, row.contacts});
    }
    first += std::ssize(batch.step);
  }
}

std::vector<DescribedContact> DescribedFile::contacts() const {
  std::vector<DescribedContact> contacts(
      static_cast<std::size_t>(NumberColumn<std::int64_t>(file_, path(), "/contacts/step").length()));
  const auto read = [&](const ValueInfo& value) {
    return words("/contacts/" + value.name, value, contacts.size());
  };
  const auto steps = read(kStep), last_steps = read(kLastStep),
             codes = read(contact_codes(head_.description)), times = read(kTime);
  for (std::size_t index = 0; index < contacts.size(); ++index) {
    if (codes[index] >= head_.description.contacts.size())
      refuse("/contacts/contact: unknown code (found " + std::to_string(codes[index]) + ")");
    contacts[index] = {codes[index], value_of<std::int64_t>(steps[index]),
                       value_of<std::int64_t>(last_steps[index]), value_of<double>(times[index])};
  }
  return contacts;
}

std::vector<DescribedBlock> DescribedFile::blocks() const {
  if (!has("blocks")) return {};
  const auto digests = column<std::uint8_t>("/blocks/digest");
  std::vector<DescribedBlock> blocks(digests.size() / sizeof(Digest));
  const auto read = [&](const ValueInfo& value, const std::string& folder = "") {
    return words("/blocks/" + folder + value.name, value, blocks.size());
  };
  const auto steps = read(kStep), is_held = read(kIsHeld);
  for (std::size_t index = 0; index < blocks.size(); ++index) {
    auto& [digest, keyframe] = blocks[index];
    std::copy_n(digests.begin() + static_cast<std::ptrdiff_t>(index * sizeof(Digest)), sizeof(Digest),
                digest.begin());
    keyframe.step = value_of<std::int64_t>(steps[index]);
    keyframe.is_held = is_held[index] != 0;
  }
  Timeline names;
  visit_timeline(names, [&](const char* name, auto first) {
    const auto words = read({.name = name, .type = value_type<decltype(first)>()});
    for (std::size_t index = 0; index < blocks.size(); ++index)
      visit_timeline(blocks[index].keyframe.timeline, [&](const char* each, auto& number) {
        if (std::string_view(each) == name) number = value_of<std::decay_t<decltype(number)>>(words[index]);
      });
  });
  for (const ValueInfo& input : head_.description.inputs.values) {
    const auto words = read(input, "inputs/");
    for (std::size_t index = 0; index < blocks.size(); ++index)
      blocks[index].keyframe.inputs.push_back(words[index]);
  }
  std::size_t index = 0;
  for (CursorOf<DescribedRows> cursor(rows()); !cursor.is_done() && index < blocks.size(); cursor.next())
    blocks[index++].keyframe.state = cursor.row().state;
  if (index < blocks.size()) refuse("/blocks: must have their first rows in /trajectory");
  return blocks;
}

void DescribedFile::read_all() const {
  DescribedSink nothing;
  show(nothing);
  static_cast<void>(contacts());
  static_cast<void>(contacts_total());
  static_cast<void>(blocks());
}

}  // namespace hyrax
