#include "tools/store/attribute_list.h"

#include <optional>

namespace hyrax {
namespace {

std::string value_of(hid_t object, const char* name) {
  if (const auto text = h5::read_text_attribute(object, name)) return '"' + *text + '"';
  if (const auto number = h5::read_integer_attribute(object, name)) return std::to_string(*number);
  return "a list";
}

struct Listing {
  std::string path;
  std::vector<std::string> lines;
};

herr_t list_attribute(hid_t object, const char* name, const H5A_info_t*, void* listing) {
  auto& [path, lines] = *static_cast<Listing*>(listing);
  lines.push_back(path + "@" + name + " = " + value_of(object, name));
  return 0;
}

herr_t list_object(hid_t file, const char* name, const H5O_info_t*, void* listing) {
  auto& [path, lines] = *static_cast<Listing*>(listing);
  path = std::string("/") + (std::string_view(name) == "." ? "" : name);
  if (path == "/provenance") return 0;
  lines.push_back(path);
  return H5Aiterate_by_name(file, name, H5_INDEX_NAME, H5_ITER_INC, nullptr, list_attribute, listing,
                            H5P_DEFAULT);
}

}  // namespace

std::vector<std::string> attribute_list(hid_t file) {
  Listing listing;
  if (H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, list_object, &listing, H5O_INFO_BASIC) < 0)
    listing.lines.emplace_back("unreadable");
  return listing.lines;
}

}  // namespace hyrax
