// What a file says in words: its objects and their attributes.
#pragma once

#include <string>
#include <vector>

#include "tools/store/hdf5.h"

namespace hyrax {

/// A line for each object, "PATH", and for each attribute of one, "PATH@NAME = VALUE", in order of their
/// names. /provenance is left out, as it is part of no comparison. Attributes that are lists are named
/// without their values: references between objects, which are addresses in the file, and codes.
[[nodiscard]] std::vector<std::string> attribute_list(hid_t file);

}  // namespace hyrax
