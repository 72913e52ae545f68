#!/usr/bin/python3
"""The pages' modules, by node and without a browser: all *_test.mjs of this folder in one process."""

import json
import os
import pathlib

from process import skip_without

skip_without("node")
# One after another: modules that are imported side by side register their tests in any order, and share one page.
TESTS = sorted(pathlib.Path(__file__).parent.glob("*_test.mjs"))
os.execvp("node", ["node", "--input-type=module", "--eval", "\n".join(f"await import({json.dumps(test.as_uri())});" for test in TESTS)])
