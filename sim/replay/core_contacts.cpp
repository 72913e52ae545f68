#include "sim/replay/core_contacts.h"

#include "sim/replay/contact_kernel.h"
#include "sim/trace/core_record.h"
#include "sim/trace/step_text.h"

namespace hyrax {

const Kernel& core_with_recorded_contacts() {
  static const ContactKernel kernel = [] {
    const std::optional<TracedStep> step = read_step(core_record().step);
    return ContactKernel({std::shared_ptr<const Kernel>(), &compiled_kernel()},
                         step ? make_step_program(*step) : nullptr);
  }();
  return kernel;
}

std::string_view why_contacts_from_rows() { return core_record().why_incomplete; }

}  // namespace hyrax
