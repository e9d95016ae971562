#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDateEdit>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QTableView>
#include <QTimeEdit>
#include <atomic>
#include <nlohmann/json.hpp>

#include "app/gui/docks/export/export_dialog.h"
#include "app/gui/docks/export/movie_actions.h"
#include "app/gui/docks/export/table_text.h"
#include "app/gui/docks/sheets/book_view.h"
#include "app/gui/docks/sheets/sheet_form.h"
#include "app/gui/view/time/time_strip.h"
#include "tests/gui/answers_window.h"

namespace noonmark {
namespace {

using test::AnswersWindow;
using test::waitFor;
using testing::HasSubstr;

QByteArray contentOfFile(const QString& name) {
    QFile file(name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return file.readAll();
}

/// The window with its dialogs of export.
struct ExportWindow : AnswersWindow {
    QString out = folder.filePath(QStringLiteral("out"));

    void trigger(const char* keys) {
        for (const QMenu* menu : window->menuBar()->findChildren<QMenu*>())
            for (QAction* action : menu->actions())
                if (action->shortcut() == QKeySequence(QLatin1String(keys))) return action->trigger();
        ADD_FAILURE() << "no action for " << keys;
    }
    template <class Dialog>
    Dialog* openDialog(const char* keys) {
        trigger(keys);
        return window->findChild<Dialog*>();
    }
    template <class Field>
    static Field* fieldOf(const QWidget& dialog, const char* name) {
        return dialog.findChild<Field*>(QLatin1String(name));
    }
    static bool choose(const ExportDialog& dialog, ExportChoice::Subject subject) {
        auto* subjects = fieldOf<QComboBox>(dialog, "exportSubject");
        const int at = subjects->findData(int(subject));
        if (at >= 0) subjects->setCurrentIndex(at);
        return at >= 0;
    }
    void write(const ExportDialog& dialog) {
        fieldOf<QLineEdit>(dialog, "exportFolder")->setText(out);
        fieldOf<QPushButton>(dialog, "exportWrite")->click();
        ASSERT_TRUE(waitFor([this] { return !workbench().writing().busy(); }));
    }
    [[nodiscard]] QString inFolder(const char* name) const {
        return out + QLatin1Char('/') + QLatin1String(name);
    }
    std::string message() { return window->panel().messages().text().toStdString(); }
};

TEST_F(ExportWindow, WithoutAResultThePictureOfTheViewIsOfferedInAnySize) {
    auto* dialog = openDialog<ExportDialog>("Ctrl+E");
    ASSERT_NE(dialog, nullptr);
    EXPECT_FALSE(choose(*dialog, ExportChoice::Subject::shown)) << "there is no result";
    ASSERT_TRUE(choose(*dialog, ExportChoice::Subject::view));
    fieldOf<QLineEdit>(*dialog, "exportFolder")->setText(out);
    fieldOf<QSpinBox>(*dialog, "exportPixels")->setValue(2000);  // the window is 900 wide
    fieldOf<QSpinBox>(*dialog, "exportHeight")->setValue(1100);
    const auto written = [&](bool framed) {
        QFile::remove(inFolder("view.png"));
        fieldOf<QCheckBox>(*dialog, "exportFramed")->setChecked(framed);
        fieldOf<QPushButton>(*dialog, "exportWrite")->click();
        EXPECT_TRUE(waitFor([&] { return !QImage(inFolder("view.png")).isNull(); }));
        return QImage(inFolder("view.png")).convertToFormat(QImage::Format_RGB32);
    };
    const QImage framed = written(true);
    EXPECT_EQ(framed.size(), QSize(2000, 1100));
    EXPECT_EQ(framed.pixelColor(3, 3), QColor(Qt::white)) << "the margin";
    window->resize(760, 600);
    const QImage bare = written(false);
    EXPECT_EQ(bare.size(), QSize(2000, 1100));
    EXPECT_NE(bare.pixelColor(3, 3), QColor(Qt::white)) << "the view";
    window->resize(900, 640);
    EXPECT_EQ(written(false), bare) << "whatever the size of the window";
}

TEST_F(ExportWindow, APictureIsAsWideAsAsked) {
    study();
    auto* dialog = openDialog<ExportDialog>("Ctrl+E");
    ASSERT_NE(dialog, nullptr);
    EXPECT_FALSE(fieldOf<QPushButton>(*dialog, "exportWrite")->isEnabled()) << "no folder yet";
    EXPECT_FALSE(choose(*dialog, ExportChoice::Subject::scenarios)) << "one scenario alone";
    fieldOf<QSpinBox>(*dialog, "exportPixels")->setValue(800);
    write(*dialog);
    EXPECT_EQ(QImage(inFolder("shadow.png")).width(), 800) << message();
    EXPECT_TRUE(QFile::exists(inFolder("cells.csv")));
}

TEST_F(ExportWindow, ASavedResultHasItsPictureAndPage) {
    study();
    keep("June");
    showSaved("June");
    auto* dialog = openDialog<ExportDialog>("Ctrl+E");
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(fieldOf<QSpinBox>(*dialog, "exportPixels")->isEnabled()) << "there is a picture";
    fieldOf<QSpinBox>(*dialog, "exportPixels")->setValue(900);
    write(*dialog);
    EXPECT_EQ(QImage(inFolder("result.png")).width(), 900) << message();
    EXPECT_TRUE(contentOfFile(inFolder("result.pdf")).startsWith("%PDF"));
    EXPECT_FALSE(contentOfFile(inFolder("result.tif")).isEmpty());
    EXPECT_THAT(contentOfFile(inFolder("result.json")).toStdString(), HasSubstr("shadow_area_m2"));
}

TEST_F(ExportWindow, ASavedResultHasItsSheets) {
    study();
    keep("June");
    showSaved("June");
    auto* dialog = openDialog<ExportDialog>("Ctrl+E");
    ASSERT_NE(dialog, nullptr);
    auto* sheets = fieldOf<QCheckBox>(*dialog, "exportSheets");
    ASSERT_TRUE(sheets->isEnabled());
    sheets->setChecked(true);
    EXPECT_TRUE(waitFor([&] { return !dialog->busy() && !dialog->pages().picture().isNull(); }))
        << "the page is shown before it is filed";
    write(*dialog);
    EXPECT_TRUE(contentOfFile(inFolder("sheets.pdf")).startsWith("%PDF")) << message();
}

TEST_F(ExportWindow, TheNameOfTheSheetsCanBeChosen) {
    study();
    auto* dialog = openDialog<ExportDialog>("Ctrl+E");
    ASSERT_NE(dialog, nullptr);
    auto* name = fieldOf<QLineEdit>(*dialog, "exportSheetsName");
    EXPECT_FALSE(name->isVisible()) << "there are no sheets";
    fieldOf<QCheckBox>(*dialog, "exportSheets")->setChecked(true);
    EXPECT_TRUE(name->isVisible());
    name->setText(QStringLiteral("report"));
    EXPECT_FALSE(fieldOf<QPushButton>(*dialog, "exportWrite")->isEnabled()) << "report.pdf is another file";
    name->setText(QStringLiteral("Mill Lane"));
    EXPECT_THAT(fieldOf<QLabel>(*dialog, "exportFiles")->text().toStdString(), HasSubstr("Mill Lane.pdf"));
    write(*dialog);
    EXPECT_TRUE(contentOfFile(inFolder("Mill Lane.pdf")).startsWith("%PDF")) << message();
    EXPECT_FALSE(QFile::exists(inFolder("sheets.pdf")));
}

TEST_F(ExportWindow, MeasuredScenariosAreExportedSideBySide) {
    workbench().measureAll();
    ASSERT_TRUE(waitFor([this] { return workbench().measuredScenarios().size() == 2; }));
    auto* dialog = openDialog<ExportDialog>("Ctrl+E");
    ASSERT_NE(dialog, nullptr);
    ASSERT_TRUE(choose(*dialog, ExportChoice::Subject::scenarios));
    EXPECT_FALSE(fieldOf<QSpinBox>(*dialog, "exportPixels")->isEnabled()) << "there is no picture";
    write(*dialog);
    const QList<QByteArray> lines = contentOfFile(inFolder("scenarios.csv")).trimmed().split('\n');
    ASSERT_EQ(lines.size(), 3) << message();
    EXPECT_TRUE(lines[1].startsWith("Existing,0,"));
    EXPECT_TRUE(lines[2].startsWith("Tower,1,")) << "one change: the new tower";
    EXPECT_TRUE(contentOfFile(inFolder("scenarios.pdf")).startsWith("%PDF"));
    EXPECT_FALSE(contentOfFile(inFolder("scenarios.tif")).isEmpty());
    const auto record = nlohmann::json::parse(contentOfFile(inFolder("scenarios.json")).toStdString());
    ASSERT_TRUE(record["repeat"].is_string()) << record["repeat_note"];
    EXPECT_THAT(record["repeat"].get<std::string>(),
                testing::AllOf(HasSubstr("noonmark-cli scenarios small.noonmark.gpkg"),
                               HasSubstr("--scenario Existing"), HasSubstr("--scenario Tower")))
        << "so that it can be verified";
}

TEST_F(ExportWindow, SheetsAreShownBeforeTheyAreFiledWithTheProjectBeside) {
    study();
    auto* dialog = openDialog<ExportDialog>("Ctrl+E");
    ASSERT_NE(dialog, nullptr);
    ASSERT_TRUE(waitFor([&] { return !dialog->busy(); }));
    EXPECT_TRUE(dialog->pages().picture().isNull()) << "none are asked for";
    EXPECT_THAT(fieldOf<QLabel>(dialog->pages(), "sheetPicture")->text().toStdString(),
                HasSubstr("Sheets with a title block"))
        << "it says how to get them";
    EXPECT_FALSE(dialog->findChild<SheetForm*>()->isVisible()) << "what would have no effect";
    const QRect before = dialog->geometry();
    fieldOf<QCheckBox>(*dialog, "exportSheets")->setChecked(true);
    ASSERT_TRUE(waitFor([&] { return !dialog->busy() && !dialog->pages().picture().isNull(); }));
    EXPECT_EQ(dialog->geometry(), before) << "nothing moves under the pointer";
    const auto* form = dialog->findChild<SheetForm*>();
    ASSERT_NE(form, nullptr);
    const auto* scroll = qobject_cast<QScrollArea*>(form->parentWidget()->parentWidget());
    ASSERT_NE(scroll, nullptr);
    const auto* folderRow = fieldOf<QPushButton>(*dialog, "exportBrowse");
    EXPECT_EQ(scroll->mapTo(dialog, QPoint(scroll->width(), 0)).x(),
              folderRow->mapTo(dialog, QPoint(folderRow->width(), 0)).x())
        << "its scroll bar is at the edge of the fields";
    EXPECT_FALSE(fieldOf<QPushButton>(*dialog, "exportOpenFolder")->isEnabled()) << "nothing is written";
    fieldOf<QCheckBox>(*dialog, "exportWithProject")->setChecked(true);
    write(*dialog);
    EXPECT_TRUE(contentOfFile(inFolder("sheets.pdf")).startsWith("%PDF")) << message();
    EXPECT_TRUE(QFile::exists(inFolder("small.noonmark.gpkg"))) << "the project";
    EXPECT_TRUE(fieldOf<QPushButton>(*dialog, "exportOpenFolder")->isEnabled());
    EXPECT_TRUE(dialog->isVisible()) << "for a look at the files, or another export";
}

TEST_F(ExportWindow, WhatIsWrittenShowsInTheDialogWhichTakesNoSecondOneMeanwhile) {
    study();
    auto* dialog = openDialog<ExportDialog>("Ctrl+E");
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(fieldOf<QPushButton>(*dialog, "exportSaveFirst")->isHidden()) << "the project has a file";
    auto* button = fieldOf<QPushButton>(*dialog, "exportWrite");
    fieldOf<QLineEdit>(*dialog, "exportFolder")->setText(folder.filePath(QStringLiteral("out")));
    ASSERT_TRUE(button->isEnabled());
    button->click();
    ASSERT_TRUE(workbench().writing().busy());
    EXPECT_FALSE(button->isEnabled());
    ASSERT_TRUE(waitFor([&] { return !workbench().writing().busy(); }));
    EXPECT_TRUE(button->isEnabled());
}

TEST_F(ExportWindow, OfUnsavedChangesItIsSaidThatTheyCannotBeVerifiedAndTheyAreSavedFirst) {
    study();
    session().goTo("Tower");
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("lower")));
    study();
    auto* dialog = openDialog<ExportDialog>("Ctrl+E");
    ASSERT_NE(dialog, nullptr);
    auto* save = fieldOf<QPushButton>(*dialog, "exportSaveFirst");
    auto* words = fieldOf<QLabel>(*dialog, "exportUnsaved");
    EXPECT_FALSE(save->isHidden());
    EXPECT_TRUE(words->text().contains(QStringLiteral("cannot be verified"))) << words->text().toStdString();
    save->click();
    ASSERT_TRUE(waitFor([&] { return save->isHidden(); }));
    EXPECT_TRUE(words->isHidden());
    EXPECT_FALSE(session().hasUnsavedWork());
    write(*dialog);
    const auto record = nlohmann::json::parse(contentOfFile(inFolder("study.json")).toStdString());
    EXPECT_TRUE(record["repeat"].is_string()) << record["repeat_note"];
    session().goTo(existingCity);
    EXPECT_TRUE(save->isHidden()) << "no change of the project";
}

TEST_F(ExportWindow, SheetsAreLaidOutAnewOnlyWhereSomethingElseIsPrinted) {
    study();
    std::atomic<int> layings = 0;
    ExportChoice first;
    first.sheets = true;
    auto* dialog = new ExportDialog(
        first, {},
        {[this](const ExportChoice& choice) { return workbench().filesOf(choice); },
         [&](const ExportChoice& choice) {
             SheetsToMake sheets = workbench().sheetsOf(choice);
             sheets.make = [&, make = sheets.make](Progress& progress, const std::stop_token& stop) {
                 ++layings;
                 return make(progress, stop);
             };
             return sheets;
         },
         [](const ExportChoice&) { return false; }, [](const ExportChoice&) { return false; },
         [](const ExportChoice&) { return false; }},
        session(), window.get());
    const auto settle = [&] { return waitFor([&] { return !dialog->busy(); }); };
    const std::vector<ExportDialog::Subject> subjects{
        {ExportChoice::Subject::shown, QStringLiteral("Study")}};
    dialog->offer(subjects);
    ASSERT_TRUE(settle());
    EXPECT_EQ(layings, 1);
    dialog->offer(subjects);  // as after each change of Results
    ASSERT_TRUE(settle());
    fieldOf<QSpinBox>(*dialog, "exportPixels")->setValue(800);
    fieldOf<QCheckBox>(*dialog, "exportCells")->setChecked(false);
    ASSERT_TRUE(settle());
    EXPECT_EQ(layings, 1) << "sheets have neither the picture nor the cells";
    Project named = session().project();
    named.sheets.titleBlock.client = "The town";
    session().change(std::move(named), QStringLiteral("Title block"));
    ASSERT_TRUE(settle());
    EXPECT_EQ(layings, 2);
    delete dialog;
}

TEST_F(ExportWindow, FollowsWhatIsShown) {
    study();
    auto* dialog = openDialog<ExportDialog>("Ctrl+E");
    ASSERT_NE(dialog, nullptr);
    const QString before = fieldOf<QComboBox>(*dialog, "exportSubject")->currentText();
    keep("June");
    showSaved("June");
    ASSERT_TRUE(
        waitFor([&] { return fieldOf<QComboBox>(*dialog, "exportSubject")->currentText() != before; }));
    EXPECT_THAT(fieldOf<QLabel>(*dialog, "exportFiles")->text().toStdString(), HasSubstr("result.json"));
}

TEST_F(ExportWindow, AMovieOfADayIsWritten) {
    const QString file = folder.filePath(QStringLiteral("day.gif"));
    MovieChoice choice;
    choice.area = MovieChoice::Area::region;
    choice.everyMin = 240;
    choice.format.size = {128, 72};
    window->movies().writeTo(file, choice);
    ASSERT_TRUE(waitFor([this] { return !window->movies().writing().busy(); }));
    const QByteArray gif = contentOfFile(file);
    EXPECT_TRUE(gif.startsWith("GIF89a")) << message();
    const auto frames = gif.count(QByteArray::fromHex("21f904"));  // a graphic control extension each
    EXPECT_THAT(frames, testing::AllOf(testing::Ge(2), testing::Le(4))) << "every four hours with the sun up";
    EXPECT_THAT(message(), HasSubstr("frames"));
    window->movies().writeTo(folder.filePath(QStringLiteral("movie.txt")), choice);
    ASSERT_TRUE(waitFor([this] { return !window->movies().writing().busy(); }));
    EXPECT_FALSE(QFile::exists(folder.filePath(QStringLiteral("movie.txt"))));
}

TEST_F(ExportWindow, AMovieOfTheViewIsFilmedAndCanBeStopped) {
    const QString file = folder.filePath(QStringLiteral("view.gif"));
    MovieChoice choice;
    choice.area = MovieChoice::Area::camera;
    choice.everyMin = 240;
    choice.format.size = {320, 240};
    const ShownTime before = window->panel().time().look();
    window->movies().writeTo(file, choice);
    ASSERT_TRUE(waitFor([this] { return !window->movies().writing().busy(); }));
    const QByteArray gif = contentOfFile(file);
    EXPECT_TRUE(gif.startsWith("GIF89a")) << message();
    EXPECT_THAT(gif.count(QByteArray::fromHex("21f904")), testing::AllOf(testing::Ge(2), testing::Le(4)));
    EXPECT_EQ(window->panel().time().look(), before);
    choice.everyMin = 1;
    const QString stopped = folder.filePath(QStringLiteral("stopped.gif"));
    window->movies().writeTo(stopped, choice);
    window->movies().writing().cancel();
    ASSERT_TRUE(waitFor([this] { return !window->movies().writing().busy(); }));
    EXPECT_FALSE(QFile::exists(stopped));
    EXPECT_EQ(window->panel().time().look(), before);
}

TEST_F(ExportWindow, AMovieSaysWhichTimesHaveNoFrame) {
    const QString file = folder.filePath(QStringLiteral("year.gif"));
    MovieChoice choice;
    choice.kind = MovieChoice::Kind::year;
    choice.area = MovieChoice::Area::region;
    choice.at = std::chrono::hours(7);  // before sunrise in winter
    choice.format.size = {64, 64};
    window->movies().writeTo(file, choice);
    ASSERT_TRUE(waitFor([this] { return !window->movies().writing().busy(); }));
    EXPECT_THAT(message(), HasSubstr("sun below the horizon"));
}

TEST_F(ExportWindow, DateAndTimeOfAMovieAndOfTheStripFollowEachOther) {
    using namespace std::chrono_literals;
    TimeStrip& strip = window->panel().time();
    const auto year = strip.look().date.year();
    strip.choose({ShownSpan::moment, year / std::chrono::June / 21, 9h});
    auto* dialog = openDialog<MovieDialog>("Ctrl+Shift+E");
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->choice().date, CivilDate(year / std::chrono::June / 21));
    auto* date = fieldOf<QDateEdit>(*dialog, "movieDate");
    date->setDate(QDate(int(year), 12, 21));
    EXPECT_EQ(strip.look(), (ShownTime{ShownSpan::moment, year / std::chrono::December / 21, 9h}));
    fieldOf<QTimeEdit>(*dialog, "movieTime")->setTime(QTime(14, 30));
    EXPECT_EQ(strip.look().at, 14h + 30min);
    date->setDate(QDate(2028, 2, 29));
    EXPECT_EQ(strip.look().date, CivilDate(year / std::chrono::February / 28)) << "in a year without one";
    EXPECT_EQ(date->date(), QDate(2028, 2, 29)) << "what was typed stays";
    strip.choose({ShownSpan::moment, year / std::chrono::March / 21, 10h});
    EXPECT_EQ(date->date(), QDate(2028, 3, 21)) << "the movie's year is its own";
    EXPECT_EQ(dialog->choice().at, 10h);
}

TEST_F(ExportWindow, ASwipeIsOfferedOnlyWithABaseline) {
    auto* alone = openDialog<MovieDialog>("Ctrl+Shift+E");
    ASSERT_NE(alone, nullptr);
    EXPECT_EQ(fieldOf<QComboBox>(*alone, "movieKind")->count(), 3) << "a period of one day";
    delete alone;
    session().goTo("Tower");
    session().compareWith(existingCity);
    auto* comparing = openDialog<MovieDialog>("Ctrl+Shift+E");
    ASSERT_NE(comparing, nullptr);
    EXPECT_EQ(fieldOf<QComboBox>(*comparing, "movieKind")->count(), 4);
    EXPECT_THAT(comparing->choice().title, HasSubstr("Tower compared with"));
}

TEST_F(ExportWindow, TablesAndFiguresAreCopied) {
    study();
    auto* table = window->findChild<QTableView*>(QStringLiteral("scenarioTable"));
    ASSERT_TRUE(window->copying().copyText(table->viewport()));
    const QStringList lines = QGuiApplication::clipboard()->text().split(QLatin1Char('\n'));
    EXPECT_TRUE(lines[0].startsWith(QStringLiteral("Scenario\tChanges\tHeight, m\tFloor area, m²\t")));
    EXPECT_TRUE(lines[1].startsWith(QStringLiteral("Existing\t0\t")));
    EXPECT_TRUE(lines[2].startsWith(QStringLiteral("Tower\t1\t70.0\t")));
    ASSERT_TRUE(window->copying().copyText(window->findChild<ResultsDock*>()));
    EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(QStringLiteral("Shadow area\t")));
    EXPECT_FALSE(window->copying().copyText(&window->panel())) << "no table: a picture is taken";
}

TEST_F(ExportWindow, ThePictureOfTheViewIsCopied) {
    QGuiApplication::clipboard()->clear();
    window->results().copyPicture();
    ASSERT_TRUE(waitFor([] { return !QGuiApplication::clipboard()->image().isNull(); }));
    EXPECT_GT(QGuiApplication::clipboard()->image().height(), 200);
}

TEST(TableTexts, KeepOneRowALineWhateverACellHolds) {
    QStandardItemModel model(2, 2);
    model.setHorizontalHeaderLabels({QStringLiteral("Name"), QStringLiteral("Height\tm")});
    model.setItem(0, 0, new QStandardItem(QStringLiteral("Tab\there")));
    model.setItem(0, 1, new QStandardItem(QStringLiteral("12")));
    model.setItem(1, 0, new QStandardItem(QStringLiteral("Two\nlines")));
    model.setItem(1, 1, new QStandardItem(QStringLiteral("7")));
    model.item(0, 0)->appendRow({new QStandardItem(QStringLiteral("inside")), new QStandardItem(QString())});
    EXPECT_EQ(makeTableText(model), QStringLiteral("Name\tHeight m\nTab here\t12\ninside\t\nTwo lines\t7\n"));
    EXPECT_EQ(makeTableText(model, {model.index(1, 1)}), QStringLiteral("Name\tHeight m\nTwo lines\t7\n"));
}

}  // namespace
}  // namespace noonmark
