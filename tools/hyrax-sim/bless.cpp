#include "tools/app/bless/paper_blesser.h"

namespace hyrax {
namespace {

ExitCode bless_paper(const Core& core, BlessRequest& request) { return bless(*blesser_of(core), request); }

void declare(Options& options, BlessRequest& request) {
  declare_bless(options, request, "error bounds",
                "print what differs in every scenario, and all contacts that moved");
}

}  // namespace

Command bless_command() {
  return {.name = "bless",
          .summary = "accept current results as the new golden files, with a reason",
          .example =
              "hyrax-sim bless scenarios/flings/first-fling.json --reason 'a longer throw'\n"
              "  hyrax-sim bless scenarios --accept contacts --reason 'drag is weaker' --dry-run\n"
              "  hyrax-sim bless --prune",
          .is_common = true,
          .declare = with_request<BlessRequest>(declare, bless_paper)};
}

}  // namespace hyrax
