#include "app/gui/tools/massing/massing_form.h"

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

namespace noonmark {
namespace {

// 152.5 m are 43 storeys of 3.5 m and 2 m more, which the last storey takes.
TEST(MassingForm, ATypedHeightIsKeptWhenNoNumberOfStoreysFitsIt) {
    MassingForm form;
    form.show({.storeyHeightM = 3.5, .storeys = 10});
    form.findChild<QDoubleSpinBox*>(QStringLiteral("totalHeight"))->setValue(152.5);
    EXPECT_EQ(form.settings().heightM, 152.5);
    EXPECT_EQ(form.settings().storeys, 0);
    EXPECT_EQ(form.findChild<QSpinBox*>(QStringLiteral("storeys"))->value(), 43);
    EXPECT_EQ(form.findChild<QDoubleSpinBox*>(QStringLiteral("totalHeight"))->value(), 152.5);
    form.findChild<QSpinBox*>(QStringLiteral("storeys"))->setValue(44);
    EXPECT_EQ(form.settings().storeys, 44);
    EXPECT_EQ(form.settings().heightM, 0);
}

TEST(MassingForm, TakesFurtherTowers) {
    MassingForm form;
    form.show({.storeyHeightM = 3.5, .storeys = 12});
    EXPECT_FALSE(form.findChild<QWidget*>(QStringLiteral("towerGap"))->isEnabled());
    form.findChild<QPushButton*>(QStringLiteral("addTower"))->click();
    ASSERT_EQ(form.settings().further.size(), 1U);
    EXPECT_EQ(form.settings().further[0].storeys, 12) << "as the first";
    auto* table = form.findChild<QTableWidget*>(QStringLiteral("furtherTowers"));
    static_cast<QSpinBox*>(table->cellWidget(0, 0))->setValue(7);
    EXPECT_EQ(form.settings().further[0].storeys, 7);
    auto* gap = form.findChild<QDoubleSpinBox*>(QStringLiteral("towerGap"));
    EXPECT_TRUE(gap->isEnabled());
    gap->setValue(20);
    EXPECT_EQ(form.settings().gapM, 20);
    form.findChild<QPushButton*>(QStringLiteral("removeTower"))->click();
    EXPECT_TRUE(form.settings().further.empty());
}

}  // namespace
}  // namespace noonmark
