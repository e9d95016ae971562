#include "app/gui/session/study/open_options.h"

#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QAction>
#include <QCompleter>
#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <tuple>

#include "app/gui/frame/main_window.h"
#include "app/gui/session/study/massing_preview.h"
#include "app/gui/view/panel/view_panel.h"
#include "core/study/provenance/repeat_command.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

/// The ReadSettings that have a field in the form, so that two can be compared.
auto fieldsOf(const ReadSettings& s) {
    return std::tuple(s.heightField, s.nameField, s.heightUnit, s.metresPerLevel, s.defaultHeightM, s.layer,
                      s.crs, s.lod, s.farAwayM, s.upAxis, s.meshUnit, s.meshNorthDeg, s.meshAnchor);
}

ReadSettings stated() {
    ReadSettings settings;
    settings.heightField = "HEIGHT_ROO";
    settings.nameField = "TITLE";
    settings.heightUnit = LengthUnit::usSurveyFeet;
    settings.metresPerLevel = 3.75;
    settings.defaultHeightM = 12.25;
    settings.layer = "buildings";
    settings.crs = "EPSG:2263";
    settings.lod = "2.2";
    settings.farAwayM = 12345;
    settings.upAxis = UpAxis::z;
    settings.meshUnit = LengthUnit::feet;
    settings.meshNorthDeg = -28.9125;
    settings.meshAnchor = LonLat{-73.9776543, 40.7664321};
    return settings;
}

TEST(ReadingForm, BeginsWithTheDefaults) {
    EXPECT_EQ(fieldsOf(ReadingForm().settings()), fieldsOf(ReadSettings{}));
}

TEST(ReadingForm, GivesBackWhatItShows) {
    ReadingForm form;
    form.show(stated());
    EXPECT_EQ(fieldsOf(form.settings()), fieldsOf(stated()));
    form.show(ReadSettings{});
    EXPECT_EQ(fieldsOf(form.settings()), fieldsOf(ReadSettings{}));
}

TEST(ReadingForm, EveryFieldSaysWhatItIs) {
    const ReadingForm form;
    for (const char* name :
         {"heightField", "buildingNameField", "heightUnit", "metresPerLevel", "defaultHeight", "layer", "crs",
          "lod", "farAway", "up", "meshUnit", "meshNorth", "anchored", "longitude", "latitude", "toMiddle"}) {
        const auto* field = form.findChild<QWidget*>(QString::fromLatin1(name));
        ASSERT_NE(field, nullptr) << name;
        EXPECT_FALSE(field->toolTip().isEmpty()) << name;
    }
}

TEST(ReadingForm, TheMiddleOfTheCityBecomesTheAnchor) {
    ReadingForm form;
    auto* button = form.findChild<QPushButton*>(QStringLiteral("toMiddle"));
    EXPECT_FALSE(button->isEnabled());
    form.setMiddle(LonLat{2.3522, 48.8566});
    button->click();
    EXPECT_EQ(form.settings().meshAnchor, (LonLat{2.3522, 48.8566}));
}

/// A file of two houses, 4 m and 30 m high by a field whose name says nothing.
struct FieldLists : ::testing::Test {
    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("houses.geojson"));
    OpenOptions dialog;

    void SetUp() override {
        QFile houses(file);
        ASSERT_TRUE(houses.open(QIODevice::WriteOnly));
        houses.write(R"({"type":"FeatureCollection","features":[
            {"type":"Feature","properties":{"QX7":4,"title":"Mill"},"geometry":{"type":"Polygon","coordinates":
            [[[10,50],[10.0002,50],[10.0002,50.0002],[10,50.0002],[10,50]]]}},
            {"type":"Feature","properties":{"QX7":30,"title":"Barn"},"geometry":{"type":"Polygon","coordinates":
            [[[10.0005,50],[10.0007,50],[10.0007,50.0002],[10.0005,50.0002],[10.0005,50]]]}}]})");
        houses.close();
        dialog.ask({file}, {});
        ASSERT_TRUE(waitFor([this] { return line("heightField").completer() != nullptr && !waits(); }));
    }
    [[nodiscard]] bool waits() { return dialog.reading().busy(); }
    QLineEdit& line(const char* name) { return *dialog.findChild<QLineEdit*>(QString::fromLatin1(name)); }
    // Clicks an entry of a field's list.
    void choose(const char* name, const QString& field) {
        line(name).findChild<QAction*>(QStringLiteral("openList"))->trigger();
        ASSERT_TRUE(waitFor([&] { return line(name).hasFocus(); }));
        QCompleter& list = *line(name).completer();
        const auto found = list.model()->match(list.model()->index(0, 0), Qt::UserRole, field);
        ASSERT_EQ(found.size(), 1);
        Q_EMIT list.popup()->clicked(list.completionModel()->index(found.front().row(), 0));
        ASSERT_TRUE(waitFor([&] { return line(name).text() == field; })) << line(name).text().toStdString();
    }
};

TEST_F(FieldLists, ShowSampleValuesAndWhatIsFoundByName) {
    const QAbstractItemModel& heights = *line("heightField").completer()->model();
    EXPECT_EQ(heights.index(0, 0).data().toString(),
              QStringLiteral("QX7   4, 30 (4 to 30 in 2 of 2 features)"));
    EXPECT_EQ(line("heightField").placeholderText(), QStringLiteral("none is found by name"));
    EXPECT_NE(line("heightField").findChild<QAction*>(QStringLiteral("openList")), nullptr);
    EXPECT_EQ(line("layer").completer()->model()->rowCount(), 1);
}

TEST_F(FieldLists, TheChosenFieldGivesThePreviewItsHeights) {
    EXPECT_TRUE(dialog.preview().words().contains(QStringLiteral("2 assumed")))
        << dialog.preview().words().toStdString();
    choose("heightField", QStringLiteral("QX7"));
    ASSERT_TRUE(waitFor([this] { return dialog.preview().words().contains(QStringLiteral("2 measured")); }))
        << dialog.preview().words().toStdString();
    EXPECT_TRUE(
        dialog.preview().words().contains(QStringLiteral("Lowest 4.0 m, median 30.0 m, tallest 30.0 m")))
        << dialog.preview().words().toStdString();
}

TEST_F(FieldLists, AMistakeIsReportedInThePreview) {
    ReadSettings settings;
    settings.heightField = "none";
    dialog.ask({file}, settings);
    ASSERT_TRUE(waitFor([this] { return !waits(); }));
    EXPECT_TRUE(dialog.preview().words().contains(QStringLiteral("There is no field \"none\"")))
        << dialog.preview().words().toStdString();
}

/// The window without a city, and a cube of 10 units that states no location.
struct OpenOptionsTest : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    MainWindow window{settings};
    OpenOptions* options = window.findChild<OpenOptions*>(QStringLiteral("openOptions"));
    QPushButton* remedy = window.findChild<QPushButton*>(QStringLiteral("remedy"));

    void SetUp() override {
        window.resize(900, 700);
        window.show();
    }

    QString written(const char* name, const char* text) {
        QFile file(folder.filePath(QString::fromLatin1(name)));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return file.fileName();
    }

    QString cube() {
        return written("cube.obj",
                       "o cube\nv 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 10\nv 10 0 10\nv 10 10 10\n"
                       "v 0 10 10\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    }

    [[nodiscard]] QString message() { return window.panel().messages().text(); }
    bool waitForMessage() {
        return waitFor([this] { return !message().isEmpty(); });
    }
    void pressOpen() { options->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open)->click(); }
};

TEST_F(OpenOptionsTest, AMeshWithAnAnchorIsOneBuildingThere) {
    ReadSettings reading;
    reading.upAxis = UpAxis::z;
    reading.meshUnit = LengthUnit::feet;
    reading.meshAnchor = LonLat{-73.98, 40.76};
    window.workbench().open({cube()}, reading);
    ASSERT_TRUE(waitFor([this] { return window.workbench().city() != nullptr; }));
    const City& city = window.workbench().city()->city();
    ASSERT_EQ(city.buildings.size(), 1U);
    EXPECT_NEAR(bounds(city).high.x - bounds(city).low.x, 10 * 0.3048, 1e-3);
    EXPECT_NEAR(city.frame.origin().lonDeg, -73.98, 1e-9);
}

TEST_F(OpenOptionsTest, AFileWithoutAPlaceOffersTheOptionsAndTheyOpenIt) {
    window.open({cube()});
    ASSERT_TRUE(waitForMessage());
    ASSERT_TRUE(remedy->isVisible());
    EXPECT_FALSE(options->isVisible());
    remedy->click();
    ASSERT_TRUE(options->isVisible());
    EXPECT_FALSE(options->isModal());
    EXPECT_EQ(options->findChild<QLabel*>(QStringLiteral("files"))->text(), QStringLiteral("cube.obj"));
    auto* form = options->findChild<ReadingForm*>();
    form->show(stated());
    pressOpen();
    EXPECT_FALSE(options->isVisible());
    ASSERT_TRUE(waitFor([this] { return window.workbench().city() != nullptr; }));
    EXPECT_EQ(fieldsOf(window.workbench().city()->loaded.settings.value()), fieldsOf(stated()));
    EXPECT_TRUE(message().contains(QStringLiteral("Buildings: 1")))
        << message().toStdString() << ": what was read";
}

TEST_F(OpenOptionsTest, AMissingCoordinateSystemOffersThemToo) {
    window.open({written("ground.asc",
                         "ncols 3\nnrows 3\nxllcorner 987000\nyllcorner 217000\ncellsize 10\n"
                         "1 2 3\n4 5 6\n7 8 9\n")});
    ASSERT_TRUE(waitForMessage());
    EXPECT_TRUE(message().contains(QStringLiteral("coordinate reference system"))) << message().toStdString();
    EXPECT_TRUE(remedy->isVisible());
}

TEST_F(OpenOptionsTest, AssumedHeightsAreAHeadlineThatOffersThem) {
    window.open({written(
        "town.geojson",
        R"({"type":"FeatureCollection","features":[)"
        R"({"type":"Feature","properties":{"H_BAT":7.5},"geometry":{"type":"Polygon","coordinates":[[[7.42,43.73],)"
        R"([7.4202,43.73],[7.4202,43.7302],[7.42,43.7302],[7.42,43.73]]]}},)"
        R"({"type":"Feature","properties":{"H_BAT":21.5},"geometry":{"type":"Polygon","coordinates":[[[7.43,43.73],)"
        R"([7.4302,43.73],[7.4302,43.7302],[7.43,43.7302],[7.43,43.73]]]}}]})")});
    ASSERT_TRUE(waitForMessage());
    EXPECT_TRUE(message().contains(QStringLiteral("2 of 2 heights are assumed (9.6 m)")))
        << message().toStdString();
    EXPECT_TRUE(message().contains(QStringLiteral("H_BAT (7.5 to 21.5 in 2 features)")));
    EXPECT_TRUE(remedy->isVisible());
    EXPECT_EQ(window.workbench().document().settings().period.zone, "Europe/Monaco");
}

TEST_F(OpenOptionsTest, WhatOptionsCannotMendOffersNone) {
    window.open({QStringLiteral("/no/such/city.gpkg")});
    ASSERT_TRUE(waitForMessage());
    EXPECT_FALSE(remedy->isVisible());
}

TEST_F(OpenOptionsTest, AWrongCoordinateSystemIsCorrectedWhereItWasStated) {
    ReadSettings reading;
    reading.crs = "EPSG:none";
    const QString ground = written("ground.asc",
                                   "ncols 2\nnrows 2\nxllcorner 987000\nyllcorner 217000\ncellsize 10\n"
                                   "1 2\n4 5\n");
    window.opening().openWith({ground}, reading);
    ASSERT_TRUE(waitForMessage());
    remedy->click();
    EXPECT_EQ(options->files(), QStringList{ground});
    EXPECT_EQ(options->findChild<ReadingForm*>()->settings().crs, "EPSG:none");
}

TEST_F(OpenOptionsTest, TheStudyRepeatsWhatWasStated) {
    ReadSettings reading;
    reading.upAxis = UpAxis::z;
    reading.meshAnchor = LonLat{-73.98, 40.76};
    window.opening().openWith({cube()}, reading);
    ASSERT_TRUE(waitFor([this] { return window.workbench().city() != nullptr; }));
    StudySettings question = window.workbench().document().settings();
    question.region = makeRegionFromLocalBox({{-40, -40}, {40, 40}});
    question.period.hours = 1;
    window.workbench().document().change(question, QStringLiteral("test"));
    window.workbench().run();
    ASSERT_TRUE(waitFor([this] { return window.workbench().study() != nullptr; }));
    const std::string command = makeRepeatCommand(*window.workbench().study(), 1000).value();
    EXPECT_NE(command.find("--up z --mesh-anchor -73.98,40.76"), std::string::npos) << command;
}

}  // namespace
}  // namespace noonmark
