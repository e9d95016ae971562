#include "app/gui/base/widgets/marked_slider.h"

#include <gtest/gtest.h>

#include "app/gui/view/time/time_strip.h"

namespace noonmark {
namespace {

QStringList labelsOf(const MarkedSlider& slider) {
    QStringList texts;
    for (const MarkedSlider::Label& label : slider.labels()) texts << label.text;
    return texts;
}

void expectApart(const MarkedSlider& slider) {
    const auto labels = slider.labels();
    for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_GE(labels[i].box.left(), 0);
        EXPECT_LE(labels[i].box.right(), slider.width() + 0.5);
        if (i == 0) continue;
        EXPECT_GT(labels[i].box.left(), labels[i - 1].box.right()) << slider.width();
    }
}

TEST(MarkedSliders, ShortenLabelsThatDoNotFitThenLeaveSomeOut) {
    MarkedSlider slider;
    slider.setRange(0, 364);
    slider.setMarks({{79, QStringLiteral("21 Mar"), QStringLiteral("Mar")},
                     {171, QStringLiteral("21 Jun"), QStringLiteral("Jun")},
                     {264, QStringLiteral("22 Sep"), QStringLiteral("Sep")},
                     {354, QStringLiteral("21 Dec"), QStringLiteral("Dec")}});
    slider.resize(600, slider.sizeHint().height());
    EXPECT_EQ(labelsOf(slider), (QStringList{QStringLiteral("21 Mar"), QStringLiteral("21 Jun"),
                                             QStringLiteral("22 Sep"), QStringLiteral("21 Dec")}));
    for (int width = 600; width >= 40; width -= 3) {
        slider.resize(width, slider.height());
        expectApart(slider);
        EXPECT_FALSE(slider.labels().empty());
    }
    slider.resize(60, slider.height());
    EXPECT_LT(slider.labels().size(), 4U);
    EXPECT_FALSE(labelsOf(slider).contains(QStringLiteral("21 Mar"))) << "the short form";
}

TEST(MarkedSliders, HaveRoomForTheLabelsBelowTheHandle) {
    MarkedSlider slider;
    slider.setMarks({{10, QStringLiteral("21 Mar")}});
    slider.resize(slider.sizeHint());
    EXPECT_LE(slider.labels().front().box.bottom(), slider.height());
}

TEST(MarkedSliders, OfTheTimeStripFitInAnyWindow) {
    TimeStrip strip;
    for (const int width : {1400, 700, 590, 400, 260}) {
        strip.resize(width, strip.sizeHint().height());
        strip.show();
        for (const MarkedSlider* slider : strip.findChildren<MarkedSlider*>()) expectApart(*slider);
    }
}

}  // namespace
}  // namespace noonmark
