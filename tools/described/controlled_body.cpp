#include <stdexcept>
#include <utility>

#include "tools/app/core/control_bits.h"
#include "tools/described/program.h"

namespace hyrax {
namespace {

class ControlledBody final : public DescribedBody {
 public:
  ControlledBody(std::unique_ptr<DescribedBody> body, const ControlBits& bits, std::atomic<bool>& has_changed)
      : body_(std::move(body)), bits_(bits), has_changed_(has_changed) {}

  [[nodiscard]] std::unique_ptr<DescribedBody> copy() const override {
    return std::make_unique<ControlledBody>(body_->copy(), bits_, has_changed_);
  }
  void step(double dt_s) override {
    body_->step(dt_s);
    look();
  }
  void play(const std::function<void()>& /*after_step*/, MadeRows& rows) override {
    body_->play([this] { look(); }, rows);
  }
  void add_row(bool has_contacts, MadeRows& rows) override { body_->add_row(has_contacts, rows); }
  void read(SettableList list, std::span<Word> words) override { body_->read(list, words); }
  void set(SettableList list, std::span<const std::optional<Word>> words) override {
    body_->set(list, words);
    look();
  }
  void act(std::size_t action, std::span<const Word> arguments) override {
    body_->act(action, arguments);
    look();
  }
  [[nodiscard]] Description describe() const override { return body_->describe(); }
  void contacts(std::span<std::uint8_t> flags) const override { body_->contacts(flags); }

 private:
  void look() const {
    if (!bits_.restore()) return;
    has_changed_ = true;
    throw std::runtime_error(control_bits_message(""));
  }

  std::unique_ptr<DescribedBody> body_;
  ControlBits bits_;
  std::atomic<bool>& has_changed_;
};

}  // namespace

DescribedCore controlled(DescribedCore core, std::atomic<bool>& has_changed) {
  core.make = [make = std::move(core.make), bits = ControlBits(), &has_changed] {
    return std::make_unique<ControlledBody>(make(), bits, has_changed);
  };
  return core;
}

}  // namespace hyrax
