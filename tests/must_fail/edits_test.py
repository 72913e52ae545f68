#!/usr/bin/python3
"""A few edits of the core, by all tests of edits in one process: one compilation traces the headers of all."""

from contacts_test import Contacts
from core_edits_test import CoreEdits, Library, Unnoticed
from program import main

__all__ = ["Contacts", "CoreEdits", "Library", "Unnoticed"]

if __name__ == "__main__":
    main()
