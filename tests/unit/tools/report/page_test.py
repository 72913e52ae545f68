#!/usr/bin/python3
"""The pages' plain functions, by node: page_test.mjs."""

import os
import pathlib

from process import skip_without

skip_without("node")
os.execvp("node", ["node", pathlib.Path(__file__).with_suffix(".mjs")])
