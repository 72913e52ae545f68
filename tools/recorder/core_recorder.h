// Records a program that moves a core that describes itself (tools/own_core/README.md), for Linux and
// Windows: a header of hyrax::recorder, which README.md describes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sim/described/described_run.h"
#include "sim/described/described_scenario.h"
#include "sim/described/see.h"
#include "tools/recorder/program_recorder.h"

namespace hyrax {

/// All values after a frame. Refers to the core's description.
struct CoreMoment {
  const Description* description = nullptr;
  KeptRow row = {};
  std::vector<Word> inputs = {};
  std::vector<Word> parameters = {};
  bool is_held = false;
};

/// As Tape (tape.h).
class CoreTape {
 public:
  using Start = CoreMoment;
  using Input = DescribedAction;
  using Document = DescribedScenario;

  explicit CoreTape(const CoreMoment& start);

  void add_input(const DescribedAction& action) { inputs_.push_back({frames(), action}); }
  void add_frame(const KeptRow& row);
  [[nodiscard]] std::int64_t frames() const {
    return static_cast<std::int64_t>(rows_.size() / row_bytes_) - 1;
  }

  [[nodiscard]] DescribedScenario scenario(const std::string& name) const;

 private:
  CoreMoment start_;
  std::vector<DescribedEvent> inputs_;
  std::vector<std::byte> rows_;  // Packed, row 0 first.
  std::size_t row_bytes_ = 0;
};

/// The part that knows no class.
class MomentRecorder : public ProgramRecorder<CoreTape> {
 protected:
  using ReadMoment = std::function<CoreMoment(const Description&)>;

  MomentRecorder(const std::string& path, Description description, std::string_view core_name);

  // What the core's own code throws while it is read ends the recording.
  void begin(const ReadMoment& read);
  /// What the program changed since the last frame is an event of the next one.
  void begin_frame(const ReadMoment& read);
  void end_frame(const ReadMoment& read);

 private:
  MomentRecorder(const std::string& path, std::shared_ptr<const Description> description);

  void end_if_it_throws(const std::function<void()>& work);

  std::shared_ptr<const Description> description_;  // Shared with what writes the files.
  CoreMoment last_;
};

/// The recording of one core. It never changes the core, nor what step makes of it.
template <class Core>
class CoreRecorder : public MomentRecorder {
 public:
  /// Starts at the state of the core. @param path of the file, UTF-8. @param core_name as its program has it:
  /// `pet` of pet-sim.
  CoreRecorder(const std::string& path, std::string_view core_name, Core& core)
      : MomentRecorder(path, DescribedBodyOf<Core>::description(), core_name) {
    begin(moment_of(core, 0.0, false));
  }

  /// A frame: calls core.step(dt_s). What the program changed before it, of inputs and state, is a `set` of
  /// the scenario.
  void step(Core& core, double dt_s) {
    begin_frame(moment_of(core, dt_s, false));
    static_cast<void>(core.step(dt_s));
    end_frame(moment_of(core, dt_s, false));
  }
  /// A frame that passes without a step.
  void hold(Core& core, double dt_s) {
    begin_frame(moment_of(core, dt_s, true));
    end_frame(moment_of(core, dt_s, true));
  }

 private:
  static ReadMoment moment_of(Core& core, double dt_s, bool is_held) {
    return [&core, dt_s, is_held](const Description& description) {
      const auto words = [&](SettableList list, const ValueList& values) {
        std::vector<Word> read(values.values.size());
        see::visit(core, list, description,
                   [&](const ValueList& described) { return see::Reader<false>(described, read); });
        return read;
      };
      CoreMoment now{.description = &description, .is_held = is_held};
      now.row.dt_s = dt_s;
      now.row.state = words(SettableList::state, description.state);
      now.row.contacts.resize(description.contacts.size());
      if (!is_held) see::read_contacts(core, now.row.contacts);
      now.inputs = words(SettableList::inputs, description.inputs);
      now.parameters = words(SettableList::parameters, description.parameters);
      return now;
    };
  }
};

}  // namespace hyrax
