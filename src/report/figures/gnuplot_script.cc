#include <array>
#include <sstream>

#include "base/number_text.h"
#include "base/phrases.h"
#include "report/figures/gnuplot.h"
#include "report/figures/layout.h"

namespace mixity {
namespace {

/// Quotes a text as a gnuplot string.
std::string script_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < ' ' ? ' ' : c == '`' ? '\'' : c;  // gnuplot executes text in backquotes
  }
  return out + '"';
}

/// A field of the data file. gnuplot ends it at a quote, and writes it between apostrophes in its SVG.
std::string data_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text)
    if (c == '"' || c == '\'')
      out += "’";
    else
      out += c == '\\' ? '/' : static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  return out + '"';
}

int point_type(Look look) {
  return look == Look::circles ? 6 : look == Look::squares ? 4 : look == Look::triangles ? 8 : 12;
}

std::string paint(const std::string& color) { return " lc rgb " + script_string(color); }

std::string style(Look look, const std::string& color, bool bars) {
  static constexpr std::array kLines{"1.6 dt 1", "1.6 dt (14,6)", "1.6 dt (14,5,2,5)", "1.6 dt (14,4,2,4,2,4)",
                                     "1.1 dt (2,4)"};
  if (look <= Look::dotted)
    return std::string("with lines lw ") + kLines[static_cast<std::size_t>(look)] + paint(color);
  if (look == Look::band) return "with filledcurves closed fs transparent solid 0.25 noborder" + paint(color);
  return std::string(bars ? "with xyerrorbars" : "with points") + " pt " + std::to_string(point_type(look)) +
         " ps 0.6" + paint(color);
}

/// Within two decades gnuplot's own labels are too few.
std::string axis_commands(const Figure& figure, bool x) {
  const Axis& axis = x ? figure.x : figure.y;
  const std::string name(1, x ? 'x' : 'y');
  std::string text = "set " + name + "label " + script_string(axis.label) + '\n';
  if (axis.logarithmic) text += "set logscale " + name + '\n';
  const auto range = axis_range(figure, x);
  if (!range) return text;
  text += "set " + name + "range [" + shortest(range->low) + ':' + shortest(range->high) + "]\n";
  if (!axis.logarithmic)
    return text + "set " + name + "tics " + shortest(tick_step(range->high - range->low, x && figure.wide ? 10 : 6)) +
           '\n';
  if (range->high > 100 * range->low) return text + "set format " + name + " \"10^{%T}\"\n";
  std::vector<std::string> ticks;
  for (const double tick : digit_ticks(*range)) ticks.push_back(script_string(rounded(tick, 3)) + ' ' + shortest(tick));
  return ticks.empty() ? text : text + "set " + name + "tics (" + joined(ticks) + ")\n";
}

const char* position(KeyPlace key) {
  return key == KeyPlace::beside ? "outside right top" : key == KeyPlace::top_left ? "inside left top" : "above";
}

/// The plot command. Points with a hover text are drawn as labels; those with bars twice, since labels have no bars.
std::string plot_command(const Figure& figure) {
  std::vector<std::string> parts;
  std::size_t index = 0;
  for (const Series& series : figure.series) {
    if (series.points.empty()) continue;
    const bool bars = !series.bars.empty(), hover = !series.hover.empty();
    const std::string source = script_string(figure.name + ".dat") + " index " + std::to_string(index++) + " using ";
    const std::string look = style(series.look, series.color, bars);
    const std::string title = series.label.empty() ? " notitle" : " title " + script_string(series.label);
    if (bars || !hover) parts.push_back(source + (bars ? "1:2:3:4:5:6 " : "1:2 ") + look + title);
    if (!hover) continue;
    parts.push_back(source + "1:2:" + (bars ? "7" : "3") + " with labels hypertext noenhanced point pt " +
                    std::to_string(point_type(series.look)) + " ps 0.6" + paint(series.color) + " notitle");
    if (!bars && !series.label.empty()) parts.push_back("keyentry " + look + title);
  }
  for (const auto& [label, look] : figure.key)
    parts.push_back("keyentry " + style(look, "#000000", false) + " title " + script_string(label));
  return joined(parts, ", \\\n     ", "plot ");
}

}  // namespace

std::string figure_data(const Figure& figure) {
  std::ostringstream out;
  out << "# " << figure.title << '\n';
  std::size_t index = 0;
  for (const Series& series : figure.series) {
    if (series.points.empty()) continue;
    out << (index ? "\n\n" : "") << "# index " << index << (series.label.empty() ? "" : ": " + series.label) << '\n';
    ++index;
    for (std::size_t k = 0; k < series.points.size(); ++k) {
      out << shortest(series.points[k].first) << ' ' << shortest(series.points[k].second);
      if (!series.bars.empty())
        for (const double end :
             {series.bars[k].x_low, series.bars[k].x_high, series.bars[k].y_low, series.bars[k].y_high})
          out << ' ' << shortest(end);
      if (!series.hover.empty()) out << ' ' << data_text(series.hover[k]);
      out << '\n';
    }
  }
  return out.str();
}

std::string figure_script(const Figure& figure, const std::vector<std::string>& endings) {
  std::ostringstream out;
  const std::string plot = plot_command(figure);
  out << "# " << figure.title << "\n# To draw it: gnuplot " << figure.name
      << ".gp\nreset\nset encoding utf8\nset border 3\nset tics out nomirror scale 0.6\nset errorbars 0.4\n"
      << axis_commands(figure, true) << axis_commands(figure, false) << "set key " << position(figure.key_place)
      << " Left reverse samplen 2.5";
  if (!figure.key_title.empty()) out << " title " << script_string(figure.key_title) << " left";
  out << '\n';
  for (const std::string& ending : endings) {
    out << "set terminal ";
    // A journal column is 8.6 cm wide; text is then 8 pt. In a figure less than 9 cm high, gnuplot would draw the key
    // of eight runs in two columns over the figure. gnuplot has 96 dots an inch; 300 are needed.
    if (ending == ".svg")
      out << "svg size " << (figure.wide ? "890,400" : "430,305") << " dynamic font \"Helvetica,13\"";
    else if (ending == ".pdf")
      out << "pdfcairo size " << (figure.wide ? "17.8cm,9.2cm" : "8.6cm,6.1cm") << " font \"Helvetica,8\" fontscale 1";
    else
      out << "pngcairo size " << (figure.wide ? "2102,1087" : "1016,720")
          << " font \"Helvetica,8\" fontscale 3.125 linewidth 3.125 pointscale 3.125";
    out << "\nset output " << script_string(figure.name + ending) << '\n'
        << (ending == endings.front() ? plot : "replot") << '\n';
  }
  out << "set output\n";
  return out.str();
}

}  // namespace mixity
