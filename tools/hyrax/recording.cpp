#include "tools/hyrax/recording.h"

#include <algorithm>

#include "tools/files/failure.h"
#include "tools/files/path.h"

namespace hyrax {
namespace {

char name_character(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
  const bool may_stand = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
  return may_stand ? c : '-';
}

std::string numbered_path(const std::string& path, std::size_t number) {
  if (number == 1) return path;
  const FileName name = file_name(path);
  std::string numbered(name.folder);
  numbered.append(name.stem).append("-").append(std::to_string(number)).append(name.extension);
  return numbered;
}

}  // namespace

Recording::Recording(const std::string& path, const Keyframe& start, ScenarioSaver& saver)
    : first_path_(path), path_(path), saver_(saver), whole_(start), part_(start), part_paths_{path} {
  if (is_there(path))
    throw Failure(ExitCode::bad_input, path + ": exists already; give another name, or remove it first");
}

Recording Recording::next(const Keyframe& start) const {
  Recording next(free_path(first_path_), start, saver_);
  next.first_path_ = first_path_;
  return next;
}

void Recording::add_input(const Action& action) {
  whole_.add_input(action);
  part_.add_input(action);
}

void Recording::add_frame(const Keyframe& now) {
  whole_.add_frame(now.row);
  part_.add_frame(now.row);
  is_saved_ = false;
  if (part_.frames() < kPartFrames) return;
  save();
  part_ = Tape(now);
  part_paths_.push_back(numbered_path(path_, ++part_number_));
}

void Recording::save() {
  if (is_saved_) return;
  std::string& path = part_paths_.back();
  while (is_there(path) && !saver_.has_made(path)) path = numbered_path(path_, ++part_number_);
  saver_.save(path, part_.scenario(scenario_name_of(path)));
  is_saved_ = true;
}

void Recording::finish() {
  saver_.wait();
  if (whole_.frames() == 0) return;
  saver_.write(path_, whole_.scenario(scenario_name_of(path_)));
  for (const std::string& path : part_paths_)
    if (path != path_) saver_.remove(path);
}

std::string free_path(const std::string& path) {
  std::size_t number = 1;
  while (is_there(numbered_path(path, number))) ++number;
  return numbered_path(path, number);
}

std::string scenario_name_of(const std::string& path) {
  std::string name;
  for (const char c : file_name(path).stem) name += name_character(c);
  name.resize(std::min<std::size_t>(name.size(), kNameLengthMax));
  return name.empty() ? "recording" : name;
}

}  // namespace hyrax
