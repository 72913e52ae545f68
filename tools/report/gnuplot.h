// Figures by gnuplot: a script goes in, an SVG file comes out whole or not at all.
#pragma once

#include <string>

namespace hyrax {

/// Runs gnuplot, found on PATH, with `script`; what it draws becomes the file at `path`. The user's
/// own gnuplot settings play no part. A first line "# TITLE #" names the picture (svg.h). The script names a
/// terminal (figure_style.h) and no output. ERRORS, and the file at `path` stays as it was:
/// Failure(cannot_access) where gnuplot is not installed or the file cannot be written;
/// Failure(program_fault), in gnuplot's words, where it refuses the script.
void draw_figure(const std::string& path, const std::string& script);

}  // namespace hyrax
