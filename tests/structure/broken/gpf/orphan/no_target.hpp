// A fault for the layering test: a file in a folder that no target owns.
