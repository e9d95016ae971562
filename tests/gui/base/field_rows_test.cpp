#include "app/gui/base/widgets/field_rows.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>

namespace noonmark {
namespace {

enum class Sail { square, lateen };
constexpr std::array sails{Choice{Sail::square, "square", "square"},
                           Choice{Sail::lateen, "lateen", "triangular"}};

struct Boat {
    double lengthM = 12;
    int masts = 1;
    bool hasRudder = true;
    std::optional<Sail> sail;
    std::string name;
    std::vector<double> oarsM{3};
    std::optional<double> draughtM;
    bool operator==(const Boat&) const = default;
};

const Fields<Boat>& boatFields() {
    static const Fields<Boat> fields{
        field(&Boat::lengthM, {.key = "length_m",
                               .flag = "--hull-length",
                               .label = "Length",
                               .help = "Of the hull",
                               .unit = "m",
                               .range = ValueRange{2, 100}}),
        field(&Boat::masts, {.key = "masts", .flag = "--masts", .label = "Masts", .range = ValueRange{0, 7}}),
        field(&Boat::hasRudder, {.key = "rudder", .flag = "--rudder", .label = "Rudder"}),
        choiceField(&Boat::sail, sails,
                    {.key = "sail", .flag = "--sail", .label = "Sail", .whenEmpty = "none"}),
        field(&Boat::name, {.key = "name", .flag = "--name", .label = "Name", .whenEmpty = "unnamed"}),
        field(&Boat::oarsM, {.key = "oars_m", .flag = "--oars", .label = "Oars"}),
        field(&Boat::draughtM, {.key = "draught_m",
                                .flag = "--draught",
                                .label = "Draught",
                                .unit = "m",
                                .range = ValueRange{0, 9},
                                .whenEmpty = "as its length"})};
    return fields;
}

struct FieldRowsTest : ::testing::Test {
    QWidget window;
    QFormLayout* form = new QFormLayout(&window);
    FieldRows rows{boatFields().rows()};

    void SetUp() override {
        rows.addRows(*form,
                     {"--hull-length", "--masts", "--rudder", "--sail", "--name", "--oars", "--draught"});
    }
    template <class Widget>
    Widget* find(const char* name) {
        return window.findChild<Widget*>(QString::fromLatin1(name));
    }
};

TEST_F(FieldRowsTest, AnOptionalNumberMayBeUnsetAndZero) {
    auto* draught = find<QDoubleSpinBox>("draught");
    EXPECT_EQ(draught->text(), QStringLiteral("as its length"));
    Boat boat{.draughtM = 4};
    rows.take(boatFields().of(boat));
    EXPECT_FALSE(boat.draughtM);
    boat.draughtM = 0;
    rows.show(boatFields().of(boat));
    EXPECT_EQ(draught->text(), QStringLiteral("0.00 m"));
    boat.draughtM.reset();
    rows.take(boatFields().of(boat));
    EXPECT_EQ(boat.draughtM, 0);
    auto* line = draught->findChild<QLineEdit*>();
    line->clear();
    draught->interpretText();
    EXPECT_EQ(draught->text(), QStringLiteral("as its length"));
}

TEST_F(FieldRowsTest, ShowAndGiveBackEveryKind) {
    const Boat boat{20.5, 3, false, Sail::lateen, "Argo", {2.5, 3.5}};
    QSignalSpy edited(&rows, &FieldRows::edited);
    rows.show(boatFields().of(boat));
    EXPECT_EQ(edited.count(), 0);
    Boat back;
    rows.take(boatFields().of(back));
    EXPECT_EQ(back, boat);
    rows.show(boatFields().of(Boat{}));
    rows.take(boatFields().of(back));
    EXPECT_EQ(back, Boat{});
}

TEST_F(FieldRowsTest, TakeLabelTipRangeAndNameFromTheTable) {
    auto* length = find<QDoubleSpinBox>("hullLength");
    ASSERT_NE(length, nullptr);
    EXPECT_EQ(length->toolTip(), QStringLiteral("Of the hull"));
    EXPECT_EQ(length->maximum(), 100);
    EXPECT_EQ(qobject_cast<QLabel*>(form->labelForField(length))->text(), QStringLiteral("Length"));
    EXPECT_EQ(find<QCheckBox>("rudder")->text(), QStringLiteral("Rudder"));
    EXPECT_EQ(find<QComboBox>("sail")->itemText(0), QStringLiteral("none"));
    EXPECT_EQ(find<QComboBox>("sail")->itemText(2), QStringLiteral("triangular"));
    EXPECT_EQ(find<QLineEdit>("name")->placeholderText(), QStringLiteral("unnamed"));
}

TEST_F(FieldRowsTest, SayWhichFieldWasEdited) {
    QSignalSpy edited(&rows, &FieldRows::edited);
    find<QDoubleSpinBox>("hullLength")->setValue(30);
    find<QComboBox>("sail")->setCurrentIndex(1);
    ASSERT_EQ(edited.count(), 2);
    EXPECT_EQ(edited[0][0].toString(), QStringLiteral("Length"));
    Boat boat;
    rows.take(boatFields().of(boat));
    EXPECT_EQ(boat.lengthM, 30);
    EXPECT_EQ(boat.sail, Sail::square);
}

TEST_F(FieldRowsTest, LeaveAFieldAsItIsWhereItsTextIsNoValue) {
    find<QLineEdit>("oars")->setText(QStringLiteral("3, four"));
    Boat boat;
    boat.oarsM = {7};
    rows.take(boatFields().of(boat));
    EXPECT_EQ(boat.oarsM, std::vector<double>{7});
}

}  // namespace
}  // namespace noonmark
