#include "tools/store/trajectory_file.h"

#include <algorithm>
#include <cassert>
#include <filesystem>

#include "sim/reference/model.h"
#include "sim/trajectory/physics_model.h"
#include "tools/files/failure.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/platform/file_state.h"
#include "tools/platform/path.h"
#include "tools/store/isolated_read.h"
#include "tools/store/trajectory_format.h"
#include "tools/store/trajectory_parts.h"

namespace hyrax {
namespace {

bool has_common_format(hid_t type) {
  for (const hid_t common :
       {H5T_IEEE_F64LE, H5T_IEEE_F64BE, H5T_IEEE_F32LE, H5T_STD_I64LE, H5T_STD_I64BE, H5T_STD_U64LE,
        H5T_STD_I32LE, H5T_STD_U32LE, H5T_STD_I16LE, H5T_STD_U16LE, H5T_STD_I8LE, H5T_STD_U8LE})
    if (H5Tequal(type, common) > 0) return true;
  return false;
}

bool is_contiguous(hid_t dataset) {
  const h5::Handle creation(H5Dget_create_plist(dataset), H5Pclose);
  return H5Pget_layout(creation) == H5D_CONTIGUOUS;
}

std::vector<NumberColumn<double>> row_columns(hid_t file, const std::string& path) {
  std::vector<NumberColumn<double>> columns;
  for (const RowColumn& column : kRowColumns)
    columns.emplace_back(file, path, std::string("/trajectory/") + column.name);
  return columns;
}

h5::Handle open_readable(const std::string& path) {
  if (const int error = error_of_reading(path)) fail_to_read(path, error);
  if (!is_regular_file(path)) refuse_input(path + ": is not a regular file");
  h5::Handle file = h5::open_file(path);
  if (!file.is_open() && is_locked(path))
    throw Failure(ExitCode::cannot_access,
                  path + ": cannot be read: locked by another program, which may be writing it");
  constexpr std::uintmax_t kLfsPointerMax = 1024;
  if (!file.is_open() && std::filesystem::file_size(path) <= kLfsPointerMax)
    static_cast<void>(read_text_file(path));
  if (!file.is_open()) refuse_input(path + ": is not an HDF5 file, or is truncated");
  return file;
}

}  // namespace

template <class Value>
NumberColumn<Value>::NumberColumn(hid_t file, const std::string& path, const std::string& dataset,
                                  H5T_class_t type_class)
    : place_(path + ": " + dataset), dataset_(H5Dopen2(file, dataset.c_str(), H5P_DEFAULT), H5Dclose) {
  if (!dataset_.is_open()) refuse_input(place_ + ": is missing");
  const h5::Handle type(H5Dget_type(dataset_), H5Tclose);
  if (H5Tget_class(type) != type_class || H5Tget_size(type) != sizeof(Value))
    refuse_input(place_ + ": is of the wrong type");
  const h5::Handle space(H5Dget_space(dataset_), H5Sclose);
  hsize_t length = 0;
  if (H5Sget_simple_extent_ndims(space) != 1 || H5Sget_simple_extent_dims(space, &length, nullptr) != 1)
    refuse_input(place_ + ": must have one axis");
  const bool is_contiguous_dataset = is_contiguous(dataset_);
  if (length > 0 && H5Dget_storage_size(dataset_) / sizeof(Value) != length && is_contiguous_dataset)
    refuse_input(place_ + ": is incomplete");
  length_ = static_cast<std::int64_t>(length);
  is_plain_ = is_contiguous_dataset && has_common_format(type);
}

template <class Value>
void NumberColumn<Value>::read(std::int64_t first, std::int64_t count, std::vector<Value>& values) const {
  assert(first >= 0 && count >= 0 && first + count <= length_);
  values.resize(static_cast<std::size_t>(count));
  if (count == 0) return;
  // Codes of an enumeration are read as they are stored: converted, a negative one would be 0.
  const h5::Handle stored(H5Dget_type(dataset_), H5Tclose);
  const hid_t type = H5Tget_class(stored) == H5T_ENUM ? hid_t{stored} : h5::native_type<Value>();
  const herr_t result = count == length_
                            ? H5Dread(dataset_, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data())
                            : h5::read_rows(dataset_, type, static_cast<hsize_t>(first),
                                            static_cast<hsize_t>(count), values.data());
  if (result < 0) refuse_input(place_ + ": cannot be read: the file is truncated or damaged");
}

template class NumberColumn<double>;
template class NumberColumn<float>;
template class NumberColumn<std::int8_t>;
template class NumberColumn<std::int16_t>;
template class NumberColumn<std::int32_t>;
template class NumberColumn<std::int64_t>;
template class NumberColumn<std::uint8_t>;
template class NumberColumn<std::uint16_t>;
template class NumberColumn<std::uint32_t>;
template class NumberColumn<std::uint64_t>;

RunFile::RunFile(const std::string& path)
    : path_(path), file_(open_readable(path)), root_(read_root()), step_(file_, path, "/trajectory/step") {}

RunHead RunFile::read_root() const {
  const auto format = h5::read_text_attribute(file_, "format");
  if (format != kTrajectoryFormat)
    refuse("attribute format: unknown format (found " + format.value_or("none") +
           "); allowed: " + std::string(kTrajectoryFormat));
  RunHead root{.physics = text("physics"), .state_hash = text("state_hash"), .core = read_core_name(file_)};
  const auto steps = h5::read_integer_attribute(file_, "steps");
  if (!steps || *steps < 0 || *steps > kStepsMax)
    refuse("attribute steps: is missing or not an integer 0 .. 1e12");
  root.steps = *steps;
  return root;
}

std::string RunFile::text(const char* attribute) const {
  const auto text = h5::read_text_attribute(file_, attribute);
  if (!text) refuse(std::string("attribute ") + attribute + ": is missing or not text");
  return *text;
}

void RunFile::require_rows(std::int64_t length, const std::string& name) const {
  if (length != row_count())
    refuse("/trajectory/" + name + ": has the wrong length (found " + std::to_string(length) +
           "); /trajectory/step has " + std::to_string(row_count()));
}

std::int64_t RunFile::contacts_total() const {
  const h5::Handle group(H5Gopen2(file_, "contacts", H5P_DEFAULT), H5Gclose);
  const auto total = h5::read_integer_attribute(group, "total");
  if (!total) refuse("/contacts: attribute total: is missing or not an integer");
  return *total;
}

bool RunFile::has(const char* group) const { return H5Lexists(file_, group, H5P_DEFAULT) > 0; }

void RunFile::refuse(const std::string& sentence) const { refuse_input(path_ + ": " + sentence); }

TrajectoryFile::TrajectoryFile(const std::string& path, Parsing parsing)
    : RunFile(path),
      head_(read_head(parsing)),
      columns_(row_columns(file_, path)),
      contact_(file_, path, "/trajectory/contact") {
  check_lengths();
}

TrajectoryFile TrajectoryFile::open(const std::string& path, const Read& read) {
  read_isolated(path, [&] { read(TrajectoryFile(path, Parsing::off)); });
  return TrajectoryFile(path);
}

void TrajectoryFile::read_all() const {
  constexpr std::int64_t kBatchRows = 65536;
  const bool is_plain =
      step_.is_plain() && contact_.is_plain() &&
      std::all_of(columns_.begin(), columns_.end(), [](const auto& c) { return c.is_plain(); });
  // Of plain columns it is enough to read the first and the last row.
  const std::int64_t stride = is_plain ? std::max<std::int64_t>(1, row_count() - 1) : kBatchRows;
  Columns rows;
  for (std::int64_t first = 0; first < row_count(); first += stride)
    read_rows(first, is_plain ? 1 : std::min(kBatchRows, row_count() - first), rows);
  static_cast<void>(contacts());
  static_cast<void>(contacts_total());
  static_cast<void>(inputs());
  static_cast<void>(provenance());
}

FileHead TrajectoryFile::read_head(Parsing parsing) const {
  if (const auto core = h5::read_text_attribute(file_, "core_name"))
    refuse("is of the core " + *core + ", which describes itself: read it with " + *core + "-sim");
  FileHead head{root_, {}};
  const std::string scenario = text("scenario");
  if (parsing == Parsing::on) head.scenario = parse_scenario(scenario, path() + ": attribute scenario");
  if (h5::has_attribute(file_, "constants")) {
    ConstantNumbers numbers{};
    const auto values = h5::read_numbers_attribute(file_, "constants", numbers.size());
    if (!values) refuse("attribute constants: is not 5 numbers of 64 bits");
    std::ranges::copy(*values, numbers.begin());
    head.constants = constants_of(numbers);
  } else if (is_paper_model(head.physics)) {
    head.constants = paper_constants();
  }
  return head;
}

void TrajectoryFile::check_lengths() const {
  for (std::size_t column = 0; column < columns_.size(); ++column)
    require_rows(columns_[column].length(), kRowColumns[column].name);
  require_rows(contact_.length(), "contact");
  if (row_count() == 0) refuse("/trajectory: has no rows");
  std::vector<std::int64_t> last;
  step_.read(row_count() - 1, 1, last);
  if (last.front() != head_.steps)
    refuse("/trajectory/step: ends at the wrong row (found " + std::to_string(last.front()) +
           "); the attribute steps is " + std::to_string(head_.steps));
}

Columns TrajectoryFile::rows(std::int64_t first, std::int64_t count) const {
  Columns rows;
  read_rows(first, count, rows);
  return rows;
}

void TrajectoryFile::read_rows(std::int64_t first, std::int64_t count, Columns& rows) const {
  step_.read(first, count, rows.step);
  for (std::size_t column = 0; column < columns_.size(); ++column)
    columns_[column].read(first, count, rows.*kRowColumns[column].also);
  contact_.read(first, count, rows.contact);
}

std::vector<Contact> TrajectoryFile::contacts() const {
  std::vector<Contact> contacts(column<std::int64_t>("/contacts/step").size());
  for (const ColumnOf<Contact>& described : kContactColumns) {
    const std::string place = std::string("/contacts/") + described.name;
    const auto set_each = [&](const auto& values, const auto& set) {
      if (values.size() != contacts.size()) refuse(place + ": differs in length from /contacts/step");
      for (std::size_t index = 0; index < contacts.size(); ++index) set(contacts[index], values[index]);
    };
    if (const auto* const number = std::get_if<double Contact::*>(&described.get))
      set_each(column<double>(place), [&](Contact& contact, double value) { contact.** number = value; });
    else if (const auto* const row = std::get_if<std::int64_t Contact::*>(&described.get))
      set_each(column<std::int64_t>(place),
               [&](Contact& contact, std::int64_t value) { contact.** row = value; });
    else
      set_each(column<std::uint8_t>(place), [&](Contact& contact, std::uint8_t code) {
        if (code != 1 && code != 2 && code != 4 && code != 8)
          refuse("/contacts/wall: unknown code (found " + std::to_string(code) + "); allowed: 1, 2, 4, 8");
        contact.wall = static_cast<Wall>(code);
      });
  }
  return contacts;
}

std::uint8_t TrajectoryFile::walls_of_rows() const {
  const h5::Handle group(H5Gopen2(file_, "contacts", H5P_DEFAULT), H5Gclose);
  return read_sources(group);
}

std::vector<Input> TrajectoryFile::inputs() const {
  const auto frames = column<std::int64_t>("/events/frame");
  if (frames.empty()) return {};
  const auto kinds = column<std::uint8_t>("/events/kind", H5T_ENUM);
  const auto as = column<double>("/events/a");
  const auto bs = column<double>("/events/b");
  if (kinds.size() != frames.size() || as.size() != frames.size() || bs.size() != frames.size())
    refuse("/events: its datasets differ in length");
  std::vector<Input> inputs;
  for (std::size_t index = 0; index < frames.size(); ++index) {
    if (kinds[index] >= input_kind_names().size())
      refuse("/events/kind: unknown code (found " + std::to_string(kinds[index]) + "); allowed: 0 .. 7");
    const auto input = input_of({frames[index], kinds[index], as[index], bs[index]});
    if (!input)
      refuse("/events: input " + std::to_string(index) + ": its numbers do not fit its kind, " +
             std::string(input_kind_names()[kinds[index]]));
    inputs.push_back(*input);
  }
  return inputs;
}

}  // namespace hyrax
