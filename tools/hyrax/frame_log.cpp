#include "tools/hyrax/frame_log.h"

#include <cerrno>

#include "tools/files/failure.h"
#include "tools/files/json.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

Json::Array numbers(std::initializer_list<std::int64_t> values) {
  return Json::Array(values.begin(), values.end());
}

Json::Array names_of(const std::vector<Action>& actions) {
  Json::Array names;
  for (const Action& action : actions) {
    const auto* const resize = std::get_if<Resize>(&action);
    if (resize == nullptr) names.emplace_back(name_of(action));
    if (resize != nullptr && resize->window) names.emplace_back("resize-window");
    if (resize != nullptr && resize->sprite) names.emplace_back("resize-sprite");
  }
  return names;
}

}  // namespace

FrameLog::FrameLog(const std::string& path) : path_(path) {
  if (is_regular_file(path)) refuse_input(path + ": exists already; name another file, or remove it first");
  file_.reset(open_file(path, "wb"));
  if (!file_) fail_to_write(path, errno);
}

void FrameLog::frame(const Keyframe& now, const Desk& desk, const std::vector<Action>& inputs,
                     const ScreenRect& window) {
  line(to_text(Json::Object{
      {"frame", now.row.step - 1},
      {"t_s", now.row.t_s},
      {"dt_s", now.row.dt_s},
      {"x_px", now.row.x_px},
      {"y_px", now.row.y_px},
      {"vx_px_per_s", now.row.vx_px_per_s},
      {"vy_px_per_s", now.row.vy_px_per_s},
      {"held", now.is_held},
      {"window_rect_px", numbers({window.left_px, window.top_px, window.right_px, window.bottom_px})},
      {"work_area_px",
       numbers({desk.origin.x_px, desk.origin.y_px, desk.origin.x_px + desk.work_area.width_px,
                desk.origin.y_px + desk.work_area.height_px})},
      {"sprite_px", numbers({desk.sprite.width_px, desk.sprite.height_px})},
      {"inputs", names_of(inputs)}}));
}

void FrameLog::sleep(const Keyframe& now) {
  line(to_text(Json::Object{{"asleep_after_frame", now.row.step - 1}}));
}

// Flushed at once, so that the line is written even if the program is killed.
void FrameLog::line(const std::string& text) {
  if (error_ != 0) return;
  if (std::fputs((text + "\n").c_str(), file_.get()) < 0 || std::fflush(file_.get()) != 0) error_ = errno;
}

void FrameLog::finish() const {
  if (error_ != 0) fail_to_write(path_, error_);
}

}  // namespace hyrax
