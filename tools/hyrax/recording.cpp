#include "tools/hyrax/recording.h"

#include <algorithm>
#include <cstdio>

#include "tools/files/file_name.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

char name_character(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
  const bool may_stand = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
  return may_stand ? c : '-';
}

}  // namespace

Recording::Recording(const std::string& path, const Keyframe& start, ScenarioSaver& saver)
    : path_(path), saver_(saver), whole_(start), part_(start) {}

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
  ++parts_;
}

void Recording::save() {
  if (is_saved_) return;
  const std::string path = part_path(parts_);
  saver_.save(path, part_.scenario(scenario_name_of(path)));
  is_saved_ = true;
}

void Recording::finish() {
  saver_.wait();
  if (whole_.frames() == 0) return;
  write_text_file(path_, scenario_file_text(whole_.scenario(scenario_name_of(path_))));
  for (std::size_t part = 2; part <= parts_; ++part) std::remove(part_path(part).c_str());
}

std::string Recording::part_path(std::size_t part) const {
  if (part == 1) return path_;
  const FileName name = file_name(path_);
  std::string path(name.folder);
  path.append(name.stem).append("-").append(std::to_string(part)).append(name.extension);
  return path;
}

std::string scenario_name_of(const std::string& path) {
  std::string name;
  for (const char c : file_name(path).stem) name += name_character(c);
  name.resize(std::min<std::size_t>(name.size(), kNameLengthMax));
  return name.empty() ? "recording" : name;
}

}  // namespace hyrax
