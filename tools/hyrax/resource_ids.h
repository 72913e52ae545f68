// Numbers of the resources in hyrax.rc.
#pragma once

#define HYRAX_ICON 1
// A pose's PNG of 128 px times the percentage: pose * 1000 + percentage.
#define HYRAX_FLY 1000
#define HYRAX_HELD 2000
#define HYRAX_STAND 3000
#define HYRAX_SLEEP 4000
