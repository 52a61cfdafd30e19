// Words of gnuplot that all figures share.
#pragma once

#include <string>
#include <string_view>

namespace amiss::experiment {

/// In single quotes, within which gnuplot replaces nothing.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The beginning of a script that draws NAME.svg, NAME.pdf or NAME.png, as its variable `format` says.
[[nodiscard]] std::string script_head(const std::string& name);

struct Paint {
  std::string_view colour;  // #rrggbb (Okabe and Ito 2008, for all eyes)
  std::string_view point;   // gnuplot's number of the symbol: not told by colour alone
};
/// Of a method; `again`: with recomputed times beside the first ones.
[[nodiscard]] Paint paint_of(std::string_view method, bool again);

}  // namespace amiss::experiment
