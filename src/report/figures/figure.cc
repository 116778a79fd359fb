#include "report/figures/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/number_text.h"

namespace mixity {
namespace {

/// As a gnuplot string in double quotes.
std::string script_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < ' ' ? ' ' : c == '`' ? '\'' : c;  // gnuplot would run what is in backquotes
  }
  return out + '"';
}

/// A field of the data file: gnuplot ends it at a quote, and its SVG holds it between apostrophes.
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
  const auto line = [&](const char* width, const char* dashes) {
    return std::string("with lines lw ") + width + " dt " + dashes + paint(color);
  };
  switch (look) {
    case Look::solid:
      return line("1.6", "1");
    case Look::dashed:
      return line("1.6", "(14,6)");
    case Look::dash_dot:
      return line("1.6", "(14,5,2,5)");
    case Look::dash_dots:
      return line("1.6", "(14,4,2,4,2,4)");
    case Look::dotted:
      return line("1.1", "(2,4)");
    case Look::band:
      return "with filledcurves closed fs transparent solid 0.25 noborder" + paint(color);
    default:
      return std::string(bars ? "with xyerrorbars" : "with points") + " pt " + std::to_string(point_type(look)) +
             " ps 0.6" + paint(color);
  }
}

constexpr double kMargin = 0.04;  // of what the points span: no symbol is cut

/// What the points of a figure span along one axis.
struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void see(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Span span_of(const Figure& figure, bool x) {
  Span span;
  for (const Series& series : figure.series) {
    for (const auto& point : series.points) span.see(x ? point.first : point.second);
    for (const Bars& bars : series.bars) {
      span.see(x ? bars.x_low : bars.y_low);
      span.see(x ? bars.x_high : bars.y_high);
    }
  }
  return span;
}

/// 1, 2, 2.5 or 5 times a power of ten: the smallest that makes at most `most` steps of a width.
double tic_step(double width, int most) {
  const double power = std::pow(10.0, std::floor(std::log10(width / most)));
  for (const double digit : {1.0, 2.0, 2.5, 5.0})
    if (width <= digit * power * most) return digit * power;
  return 10 * power;
}

/// Within two decades gnuplot labels too little: the positions 1, 2, 5 or, where those are few, every digit.
std::string logarithmic_tics(char name, double low, double high) {
  const std::string set = std::string("set ") + name + "tics ";
  if (high > 100 * low) return std::string("set format ") + name + " \"10^{%T}\"\n";
  for (const auto& digits : {std::vector<int>{1, 2, 5}, std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9}}) {
    std::string list;
    int count = 0;
    for (int power = static_cast<int>(std::floor(std::log10(low))); power <= std::log10(high); ++power)
      for (const int digit : digits) {
        const double value = digit * std::pow(10.0, power);
        if (value < low || value > high) continue;
        list += (list.empty() ? "" : ", ") + script_string(rounded(value, 3)) + ' ' + shortest(value);
        ++count;
      }
    if (count >= 3) return set + '(' + list + ")\n";
  }
  return {};
}

/// An end that is not stated lies a little beyond the points; an axis that would have no length gets some.
std::string axis_commands(const Figure& figure, bool x) {
  const Axis& axis = x ? figure.x : figure.y;
  const char name = x ? 'x' : 'y';
  std::string text = std::string("set ") + name + "label " + script_string(axis.label) + '\n';
  if (axis.logarithmic) text += std::string("set logscale ") + name + '\n';
  const Span span = span_of(figure, x);
  double low = axis.low.value_or(span.low), high = axis.high.value_or(span.high);
  if (!std::isfinite(low) || !std::isfinite(high) || (axis.logarithmic && !(low > 0))) return text;  // nothing to show
  const double least = 1e-9 * std::max(std::abs(low), std::abs(high));
  std::string tics;
  if (axis.logarithmic) {
    if (!axis.low || high - low <= least) low /= 1.3;
    if (!axis.high || high - low <= least) high *= 1.3;
    tics = logarithmic_tics(name, low, high);
  } else {
    const double margin = high - low > least ? kMargin * (high - low) : std::max(0.1 * std::abs(low), 1e-3);
    if (!axis.low || high - low <= least) low -= margin;
    if (!axis.high || high - low <= least) high += margin;
    tics = std::string("set ") + name + "tics " + shortest(tic_step(high - low, x && figure.wide ? 10 : 6)) + '\n';
  }
  return text + "set " + name + "range [" + shortest(low) + ':' + shortest(high) + "]\n" + tics;
}

const char* place(KeyPlace key) {
  switch (key) {
    case KeyPlace::beside:
      return "outside right top";
    case KeyPlace::top_left:
      return "inside left top";
    case KeyPlace::above:
      break;
  }
  return "above";
}

/// Everything between `plot` and the end of the command. Points with something to say are drawn as labels; those with
/// bars twice, since labels have none.
std::string plotted(const Figure& figure) {
  std::string plot;
  const auto add = [&](const std::string& part) { plot += (plot.empty() ? "plot " : ", \\\n     ") + part; };
  std::size_t index = 0;
  for (const Series& series : figure.series) {
    if (series.points.empty()) continue;
    const bool bars = !series.bars.empty(), hover = !series.hover.empty();
    const std::string source = script_string(figure.name + ".dat") + " index " + std::to_string(index++) + " using ";
    const std::string look = style(series.look, series.color, bars);
    const std::string title = series.label.empty() ? " notitle" : " title " + script_string(series.label);
    if (bars || !hover) add(source + (bars ? "1:2:3:4:5:6 " : "1:2 ") + look + title);
    if (!hover) continue;
    add(source + "1:2:" + (bars ? "7" : "3") + " with labels hypertext noenhanced point pt " +
        std::to_string(point_type(series.look)) + " ps 0.6" + paint(series.color) + " notitle");
    if (!bars && !series.label.empty()) add("keyentry " + look + title);
  }
  for (const auto& [label, look] : figure.key)
    add("keyentry " + style(look, "#000000", false) + " title " + script_string(label));
  return plot;
}

}  // namespace

std::string color(std::size_t i) {
  static constexpr std::array kColors{"#000000", "#d55e00", "#0072b2", "#009e73",
                                      "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f"};
  return kColors[i % kColors.size()];
}

Look model_line(std::string_view key) {
  return key == "a" ? Look::dash_dot : key == "b" ? Look::dashed : key == "c" ? Look::solid : Look::dash_dots;
}

Look model_symbol(std::string_view key) {
  return key == "a" ? Look::triangles : key == "b" ? Look::squares : key == "c" ? Look::circles : Look::diamonds;
}

std::string model_color(std::string_view key) { return color(key == "a" ? 1 : key == "b" ? 2 : key == "c" ? 0 : 3); }

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

std::string figure_script(const Figure& figure) {
  std::ostringstream out;
  const std::string plot = plotted(figure);
  const auto key = [&](KeyPlace place_of_key, const char* size) {
    out << "set key " << place(place_of_key) << " Left reverse " << size;
    if (!figure.key_title.empty()) out << " title " << script_string(figure.key_title) << " left";
    out << '\n';
  };
  const auto svg = [&](const char* size, const std::string& name) {
    out << "set terminal svg size " << size << " dynamic font \"Helvetica,13\" background \"#ffffff\"\nset output "
        << script_string(name + ".svg") << '\n'
        << plot << '\n';
  };
  out << "# " << figure.title << "\n# Draws " << figure.name << ".svg, .pdf and .png: gnuplot " << figure.name
      << ".gp\nreset\nset encoding utf8\nset border 3\nset tics out nomirror scale 0.6\nset errorbars 0.4\n"
      << axis_commands(figure, true) << axis_commands(figure, false);
  key(figure.key_place, "samplen 2.5");
  svg(figure.wide ? "890,400" : "430,305", figure.name);
  // A column of a journal is 8.6 cm wide; text is then 8 pt. Less than 9 cm high gnuplot would put the key of eight
  // runs into two columns, in place of the figure. gnuplot has 96 dots an inch, and 300 are wanted.
  out << "set terminal pdfcairo size " << (figure.wide ? "17.8cm,9.2cm" : "8.6cm,6.1cm")
      << " font \"Helvetica,8\" fontscale 1\nset output " << script_string(figure.name + ".pdf")
      << "\nreplot\nset terminal pngcairo size " << (figure.wide ? "2102,1087" : "1016,720")
      << " font \"Helvetica,8\" fontscale 3.125 linewidth 3.125 pointscale 3.125\nset output "
      << script_string(figure.name + ".png") << "\nreplot\n";
  if (figure.wide) {  // for a phone
    // gnuplot takes long labels for longer than they are, and would find no room for a second column
    std::size_t longest = 0;
    for (const Series& series : figure.series) longest = std::max(longest, series.label.size());
    for (const auto& entry : figure.key) longest = std::max(longest, entry.first.size());
    key(KeyPlace::above, longest > 20 ? "samplen 1 vertical maxrows 7 width -8 font \",10\""
                                      : "samplen 1 vertical maxrows 7 font \",10\"");
    if (!figure.x.logarithmic) out << "set xtics auto\n";
    svg("430,460", figure.name + "_narrow");
  }
  out << "set output\n";
  return out.str();
}

}  // namespace mixity
