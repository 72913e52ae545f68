// The core of one's own header: HYRAX_DESCRIBED_HEADER is its path, HYRAX_DESCRIBED_NAME the core's name.
#include "sim/described/see.h"
#include "sim/physics/strict_arithmetic.h"  // Refuses flags that change its bits.

#include HYRAX_DESCRIBED_HEADER

// After the header: ::hyrax_core is then the header's, and the missing one only where it has none.
using namespace hyrax_missing;  // NOLINT(google-build-using-namespace): a name alone would be a second
                                // definition.

namespace hyrax {

DescribedCore built_described_core() {
  return described_core_of<::hyrax_core>(HYRAX_DESCRIBED_NAME, built_core_record());
}

}  // namespace hyrax
