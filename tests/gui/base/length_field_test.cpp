#include "app/gui/base/widgets/number_fields.h"

#include <gtest/gtest.h>

#include <QLineEdit>

#include "app/gui/base/looks/units.h"
#include "app/gui/docks/study_form/accuracy_section.h"
#include "app/gui/docks/study_form/line_form.h"
#include "app/gui/tools/massing/tower_tables.h"

namespace noonmark {
namespace {

struct LengthFieldTest : ::testing::Test {
    QLocale before;
    void SetUp() override { QLocale::setDefault(QLocale::c()); }
    void TearDown() override {
        applyUnits(UnitSystem::metric);
        QLocale::setDefault(before);
    }
    static double typed(LengthField& field, const char* text) {
        field.findChild<QLineEdit*>()->setText(QString::fromUtf8(text));
        field.interpretText();
        return field.value();
    }
};

TEST_F(LengthFieldTest, ShowsMetresAndTakesFeet) {
    const std::unique_ptr<LengthField> field(lengthField(0, 2000, 1, 3.5));
    field->setValue(3.5);
    EXPECT_EQ(field->text().toStdString(), "3.5 m");
    EXPECT_EQ(typed(*field, "12"), 12);
    EXPECT_EQ(typed(*field, "4.2 m"), 4.2);
    EXPECT_NEAR(typed(*field, "12' 6\""), 3.81, 1e-9) << "exact, though shown as 3.8 m";
    EXPECT_NEAR(typed(*field, "tall"), 3.81, 1e-9) << "stays";
    EXPECT_EQ(typed(*field, "5000"), 2000) << "the highest that is possible";
}

TEST_F(LengthFieldTest, ShowsAndTakesFeetAndInchesWhereTheUnitsAreFeet) {
    applyUnits(UnitSystem::imperial);
    const std::unique_ptr<LengthField> field(lengthField(0, 2000, 1, 3.5));
    field->setValue(3.81);
    EXPECT_EQ(field->text().toStdString(), "12' 6\"");
    EXPECT_NEAR(typed(*field, "20"), 20 * 0.3048, 1e-4) << "a number alone is in feet";
    EXPECT_NEAR(typed(*field, "3.5 m"), 3.5, 1e-9);
    EXPECT_EQ(field->text().toStdString(), "11' 5.8\"");
    field->interpretText();
    EXPECT_EQ(field->value(), 3.5) << "a text that was not changed does not round the value";
    field->stepUp();
    EXPECT_NEAR(field->value(), 3.5 + 0.3048, 1e-4) << "a foot";
}

struct LinesInFeet : LengthFieldTest {
    LineForm* form = nullptr;
    QLineEdit* offsets = nullptr;
    std::vector<double> lastM;

    void SetUp() override {
        LengthFieldTest::SetUp();
        applyUnits(UnitSystem::imperial);
        form = new LineForm;
        form->show("Yard", {});
        offsets = form->findChild<QLineEdit*>(QStringLiteral("lineOffsets"));
        QObject::connect(form, &LineForm::edited, form,
                         [this](const std::string&, const LineSettings& lines, const QString&) {
                             lastM = lines.offsetsM;
                         });
    }
    void TearDown() override {
        delete form;
        LengthFieldTest::TearDown();
    }
    void type(const char* text) {
        offsets->setText(QString::fromUtf8(text));
        Q_EMIT offsets->editingFinished();
    }
};

TEST_F(LinesInFeet, DistancesAreShownInFeetAndNotRoundedByThat) {
    EXPECT_EQ(offsets->text().toStdString(), "16' 4.85\", 32' 9.7\"");
    Q_EMIT offsets->editingFinished();
    EXPECT_TRUE(lastM.empty()) << "unchanged";
    EXPECT_EQ(form->findChild<LengthField*>(QStringLiteral("lineSpacing"))->text().toStdString(),
              "3' 3.37\"");
}

TEST_F(LinesInFeet, DistancesAreTypedInFeetOrWithTheirUnit) {
    type("12' 6\", 20");
    ASSERT_EQ(lastM.size(), 2U);
    EXPECT_NEAR(lastM[0], 3.81, 1e-9);
    EXPECT_NEAR(lastM[1], 20 * 0.3048, 1e-9);
    EXPECT_EQ(offsets->text().toStdString(), "12' 6\", 20' 0\"");
    type("3.5 m; 30 ft");
    EXPECT_EQ(lastM[0], 3.5);
    type("10 20");
    ASSERT_EQ(lastM.size(), 2U);
    EXPECT_NEAR(lastM[1], 20 * 0.3048, 1e-9) << "plain numbers with a space between them";
    type("5000, 10");
    EXPECT_EQ(offsets->text().toStdString(), "10' 0\", 20' 0\"") << "out of range: the last distances stay";
}

TEST_F(LengthFieldTest, ReadsTheDecimalCommaOfTheLanguage) {
    QLocale::setDefault(QLocale(QLocale::German));
    const std::unique_ptr<LengthField> field(lengthField(0, 5000, 2, 1));
    EXPECT_EQ(typed(*field, "3,25"), 3.25);
    EXPECT_EQ(typed(*field, "3.5"), 3.5);
    EXPECT_EQ(typed(*field, "1.250 m"), 1250) << "a point groups thousands";
}

TEST_F(LengthFieldTest, CellsOfAStudyAreInFeetWhereTheUnitsAreFeet) {
    applyUnits(UnitSystem::imperial);
    AccuracySection section;
    StudySettings settings;
    settings.receivers.cellM = 3.048;
    section.show(settings);
    const auto* cell = section.findChild<QDoubleSpinBox*>(QStringLiteral("cell"));
    EXPECT_EQ(cell->text().toStdString(), "10' 0\"");
    EXPECT_EQ(cell->value(), 3.048);
}

TEST_F(LengthFieldTest, FloorPlatesAreInSquareFeetWhereTheUnitsAreFeet) {
    applyUnits(UnitSystem::imperial);
    PlateField field;
    field.show({.areaM2 = 500});
    auto* size = field.findChild<QDoubleSpinBox*>(QStringLiteral("plateSize"));
    EXPECT_EQ(size->text().toStdString(), "5382 sq ft");
    EXPECT_EQ(field.plate().areaM2, 500) << "an area that nobody typed is not rounded";
    size->setValue(10000);
    EXPECT_NEAR(*field.plate().areaM2, 929.0304, 1e-9);
}

}  // namespace
}  // namespace noonmark
