#include "app/gui/tools/massing/massing_form.h"

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QSpinBox>

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

}  // namespace
}  // namespace noonmark
