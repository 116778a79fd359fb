#include "report/figures/svg.h"

#include <algorithm>
#include <array>

#include "report/figures/layout.h"
#include "report/figures/polyline.h"
#include "report/figures/svg_text.h"

namespace mixity {
namespace {

constexpr double kUnseen = 0.04;          // distance by which a line may visibly differ from its points
constexpr std::size_t kManyPoints = 500;  // in one series: drawn as dots

bool is_symbol(Look look) { return look >= Look::circles && look != Look::band; }

/// The dashes of a line; null for a solid one.
const char* dashes(Look look) {
  static constexpr std::array<const char*, 5> kDashes{nullptr, "9 4", "10 3.5 1.5 3.5", "10 3 1.5 3 1.5 3", "1.5 3"};
  return kDashes[static_cast<std::size_t>(look)];
}

/// The path of a symbol.
void add_symbol(SvgText& path, Look look, double x, double y) {
  constexpr double r = 2.9;
  path << "M";
  switch (look) {
    case Look::squares:
      path << x - r << " " << y - r << "h" << 2 * r << "v" << 2 * r << "h" << -2 * r;
      break;
    case Look::triangles:
      path << x << " " << y - 1.35 * r << "l" << 1.2 * r << " " << 2 * r << "h" << -2.4 * r;
      break;
    case Look::diamonds:
      path << x << " " << y - 1.4 * r << "l" << 1.4 * r << " " << 1.4 * r << "l" << -1.4 * r << " " << 1.4 * r << "l"
           << -1.4 * r << " " << -1.4 * r;
      break;
    default:
      path << x - r << " " << y << "a" << r << " " << r << " 0 1 0 " << 2 * r << " 0a" << r << " " << r << " 0 1 0 "
           << -2 * r << " 0";
  }
  path << "z";
}

class Drawing {
 public:
  Drawing(const Figure& figure, Medium medium, bool narrow)
      : figure_(figure), page_(medium == Medium::page), at_(lay_out(figure, narrow)) {}

  std::string text() {
    const std::string title = xml_escaped(figure_.title), caption = xml_escaped(figure_.caption);
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << at_.width << " " << at_.height
         << "\" role=\"img\" aria-label=\"" << title << ". " << caption << "\"><title>" << title << "</title><desc>"
         << caption << "</desc>";
    if (!page_) out_ << "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>";
    out_ << "<g font-family=\"Helvetica,Arial,sans-serif\" font-size=\"" << kFont << "\" fill=\"" << paint(color(0))
         << "\">";
    draw_axes();
    for (const Series& series : figure_.series) is_symbol(series.look) ? draw_symbols(series) : draw_line(series);
    draw_key();
    out_ << "</g></svg>\n";
    out_.text.shrink_to_fit();  // a report holds all drawings until it is written
    return std::move(out_.text);
  }

 private:
  std::string paint(const std::string& hex) const { return page_ ? themed(hex) : hex; }

  /// `room`: the available width; longer text is compressed.
  void add_label(const std::string& label, double x, double y, const char* anchor, double room, bool upright = false) {
    out_ << "<text text-anchor=\"" << anchor;
    if (upright)
      out_ << "\" transform=\"translate(" << x << " " << y << ")rotate(-90)\"";
    else
      out_ << "\" x=\"" << x << "\" y=\"" << y << "\"";
    if (label_width(label, kFont) > room) out_ << " textLength=\"" << room << "\" lengthAdjust=\"spacingAndGlyphs\"";
    out_ << ">" << label_markup(label, kFont) << "</text>";
  }

  void add_path(Look look, const std::string& color, const std::string& path) {
    const std::string painted = paint(color);
    if (look == Look::band) {
      out_ << "<path fill=\"" << painted << "\" fill-opacity=\".25\" d=\"" << path << "\"/>";
    } else if (is_symbol(look)) {
      out_ << "<path fill=\"" << painted << "\" fill-opacity=\".12\" stroke=\"" << painted
           << "\" stroke-width=\"1.2\" d=\"" << path << "\"/>";
    } else {
      out_ << "<path fill=\"none\" stroke=\"" << painted << "\" stroke-width=\"" << (look == Look::dotted ? 1.2 : 1.6)
           << "\" stroke-linejoin=\"round\"";
      if (const char* pattern = dashes(look)) out_ << " stroke-dasharray=\"" << pattern << "\"";
      out_ << " d=\"" << path << "\"/>";
    }
  }

  void draw_axes() {
    const auto& [width, height, left, right, top, bottom, x, y, key, title_x, title_y] = at_;
    SvgText grid, axes;
    axes << "M" << left << " " << top << "V" << bottom << "H" << right;
    for (const Tick& tick : x.ticks) {
      axes << "M" << x.of(tick.value) << " " << bottom << "v" << (tick.label.empty() ? 0.5 : 1) * kTick;
      if (tick.label.empty()) continue;
      grid << "M" << x.of(tick.value) << " " << top << "V" << bottom;
      add_label(tick.label, x.of(tick.value), bottom + kTick + 14, "middle", width);
    }
    for (const Tick& tick : y.ticks) {
      axes << "M" << left << " " << y.of(tick.value) << "h" << -(tick.label.empty() ? 0.5 : 1) * kTick;
      if (tick.label.empty()) continue;
      grid << "M" << left << " " << y.of(tick.value) << "H" << right;
      add_label(tick.label, left - kTick - 4, y.of(tick.value) + 0.35 * kFont, "end", width);
    }
    add_label(figure_.x.label, 0.5 * (left + right), height - 9, "middle", right - left);
    add_label(figure_.y.label, kFont + 4, 0.5 * (top + bottom), "middle", bottom - top, true);
    out_ << "<path fill=\"none\" stroke=\"" << paint(color(0)) << "\" stroke-opacity=\".1\" d=\"" << grid.text
         << "\"/><path fill=\"none\" stroke=\"" << paint(color(0)) << "\" d=\"" << axes.text << "\"/>";
  }

  void draw_line(const Series& series) {
    const bool closed = series.look == Look::band;
    Polyline places;
    places.reserve(series.points.size());
    for (const auto& [x, y] : series.points) places.emplace_back(at_.x.of(x), at_.y.of(y));
    SvgText path;
    for (const Polyline& part : cut_to_frame(places, closed, {at_.left, at_.top}, {at_.right, at_.bottom})) {
      std::string_view command = "M";
      for (const auto& [x, y] : simplified(part, kUnseen)) {
        path << command << x << " " << y;
        command = command == "M" ? "L" : " ";
      }
      if (closed) path << "Z";
    }
    if (!path.text.empty()) add_path(series.look, series.color, path.text);
  }

  bool across(double x) const { return x > at_.left - 1 && x < at_.right + 1; }
  bool along(double y) const { return y > at_.top - 1 && y < at_.bottom + 1; }

  void draw_symbols(const Series& series) {
    const std::string painted = paint(series.color);
    draw_bars(series, painted);
    const bool speaks = !series.hover.empty(), dots = !speaks && series.points.size() > kManyPoints;
    SvgText path;
    if (speaks)
      out_ << "<g fill=\"" << painted << "\" fill-opacity=\".12\" stroke=\"" << painted << "\" stroke-width=\"1.2\">";
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      const double x = at_.x.of(series.points[i].first), y = at_.y.of(series.points[i].second);
      if (!across(x) || !along(y)) continue;
      if (dots)
        path << "M" << x << " " << y << "h0";
      else
        add_symbol(path, series.look, x, y);
      if (!speaks) continue;
      out_ << "<path d=\"" << path.text << "\"><title>" << xml_escaped(series.hover[i]) << "</title></path>";
      path.text.clear();
    }
    if (speaks)
      out_ << "</g>";
    else if (dots)
      out_ << "<path fill=\"none\" stroke=\"" << painted << "\" stroke-width=\"3\" stroke-linecap=\"round\" d=\""
           << path.text << "\"/>";
    else if (!path.text.empty())
      add_path(series.look, series.color, path.text);
  }

  void draw_bars(const Series& series, const std::string& painted) {
    constexpr double kLeast = 0.2;
    SvgText path;
    for (std::size_t i = 0; i < series.bars.size(); ++i) {
      const Bars& bars = series.bars[i];
      const double x = at_.x.of(series.points[i].first), y = at_.y.of(series.points[i].second);
      const double left = std::max(at_.x.of(bars.x_low), at_.left), right = std::min(at_.x.of(bars.x_high), at_.right);
      const double low = std::min(at_.y.of(bars.y_low), at_.bottom), high = std::max(at_.y.of(bars.y_high), at_.top);
      if (along(y) && right - left > kLeast) path << "M" << left << " " << y << "H" << right;
      if (across(x) && low - high > kLeast) path << "M" << x << " " << low << "V" << high;
    }
    if (!path.text.empty())
      out_ << "<path fill=\"none\" stroke=\"" << painted << "\" stroke-opacity=\".6\" d=\"" << path.text << "\"/>";
  }

  void draw_key() {
    const double right = at_.width - 4;
    if (!figure_.key_title.empty() && !at_.key.empty())
      add_label(figure_.key_title, at_.title_x, at_.title_y + 0.35 * kFont, "start", right - at_.title_x);
    for (const KeyEntry& entry : at_.key) {
      SvgText path;
      if (entry.look == Look::band)
        path << "M" << entry.x << " " << entry.y - 5 << "h" << kSample << "v10h" << -kSample << "z";
      else if (is_symbol(entry.look))
        add_symbol(path, entry.look, entry.x + 0.5 * kSample, entry.y);
      else
        path << "M" << entry.x << " " << entry.y << "h" << kSample;
      add_path(entry.look, entry.color, path.text);
      const double label = entry.x + kSample + kSampleGap;
      add_label(entry.label, label, entry.y + 0.35 * kFont, "start", right - label);
    }
  }

  const Figure& figure_;
  bool page_;
  Layout at_;
  SvgText out_;
};

}  // namespace

std::string svg(const Figure& figure, Medium medium, bool narrow) {
  if (!figure.drawn.empty()) return medium == Medium::page ? themed_svg(figure.drawn) : figure.drawn;
  return Drawing(figure, medium, narrow).text();
}

}  // namespace mixity
