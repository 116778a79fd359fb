// Keys, labels and the frame of every figure of the shipped data and of the paper find room.
#include "report/figures/layout.h"

#include <gtest/gtest.h>

#include "report/example_results.h"
#include "report/figures/data_figures.h"
#include "report/figures/paper_figures.h"
#include "report/figures/svg_text.h"

namespace mixity {
namespace layout_test {

struct Box {
  double left, right, top, bottom;
  bool touches(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// A range that ends at a long label, as the profile of a parameter at its bound.
Figure at_a_bound() {
  return {"at_a_bound", "", {"x", 999.97, 1000.0}, {"y"}, {{"", Look::solid, "#000000", {{999.97, 3}, {1000, 0}}}}};
}

std::vector<Figure> all_figures() {
  std::vector<Figure> figures = paper_figures();
  figures.push_back(at_a_bound());
  for (const char* name : {"mergel2018", "waters_guduru2010"}) {
    const ReportedData reported = reported_data(shipped(name), name);
    for (const FigureGroup& group : data_figures(reported).groups)
      figures.insert(figures.end(), group.figures.begin(), group.figures.end());
  }
  return figures;
}

TEST(Layout, LeavesRoomForEveryText) {
  for (const Figure& figure : all_figures())
    for (const bool narrow : {false, true}) {
      const Layout at = lay_out(figure, narrow);
      std::vector<Box> boxes;
      const auto add = [&](double left, double width, double middle) {
        boxes.push_back({left, left + width, middle - 0.4 * kFont, middle + 0.4 * kFont});
      };
      for (const KeyEntry& entry : at.key)
        add(entry.x, kSample + kSampleGap + label_width(entry.label, kFont), entry.y);
      if (!figure.key_title.empty()) add(at.title_x, label_width(figure.key_title, kFont), at.title_y);
      if (figure.key_place != KeyPlace::top_left) boxes.push_back({at.left, at.right, at.top, at.bottom});
      for (const Tick& tick : at.x.ticks) {
        const double width = label_width(tick.label, kFont);
        if (width > 0) add(at.x.of(tick.value) - 0.5 * width, width, at.bottom + 12);
      }
      for (const Tick& tick : at.y.ticks) {
        const double width = label_width(tick.label, kFont);
        if (width > 0) add(at.left - kTick - 4 - width, width, at.y.of(tick.value));
      }
      boxes.push_back({0, 20, at.top, at.bottom});  // the label of y
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_GE(boxes[i].left, 0) << figure.name;
        EXPECT_LE(boxes[i].right, at.width) << figure.name << ' ' << narrow << ' ' << i;
        EXPECT_GE(boxes[i].top, 0) << figure.name;
        EXPECT_LE(boxes[i].bottom, at.height) << figure.name;
        for (std::size_t k = 0; k < i; ++k)
          EXPECT_FALSE(boxes[i].touches(boxes[k])) << figure.name << ' ' << i << ' ' << k;
      }
      EXPECT_GT((at.right - at.left) * (at.bottom - at.top), 0.4 * at.width * at.height)
          << figure.name << ' ' << narrow;
    }
}

TEST(Layout, TellsTheKeyOfAPhonesFigureAboveIt) {
  Figure figure{"f",
                "",
                {"x", 0.0, 1.0},
                {"y", 0.0, 1.0},
                {{"line", Look::solid, "#000000", {{0, 0}, {1, 1}}}},
                {},
                KeyPlace::beside};
  figure.wide = true;
  const Layout wide = lay_out(figure, false), narrow = lay_out(figure, true);
  EXPECT_GT(wide.key.at(0).x, wide.right);
  EXPECT_LT(narrow.key.at(0).y, narrow.top);
  EXPECT_EQ(wide.width, 890);
  EXPECT_EQ(narrow.width, 430);
}

}  // namespace layout_test
}  // namespace mixity
