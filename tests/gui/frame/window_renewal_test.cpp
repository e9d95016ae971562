#include "app/gui/docks/review/review_dock.h"
#include "app/gui/docks/review/rule_form.h"
#include "app/gui/frame/window_start.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTextEdit>
#include <QUndoStack>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/frame/main_window.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/language/language.h"
#include "tests/gui/small_project.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

struct RenewalTest : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    std::unique_ptr<WindowRenewal> renewal;

    void SetUp() override {
        settings.setValue(QStringLiteral("unsavedFolder"), folder.filePath(QStringLiteral("unsaved")));
        const QString file = folder.filePath(QStringLiteral("small.noonmark.gpkg"));
        ASSERT_TRUE(ProjectFile::create(file.toStdString(), test::smallProject()));
        renewal = std::make_unique<WindowRenewal>(settings);
        window().resize(1000, 700);
        window().show();
        window().open({file});
        ASSERT_TRUE(waitFor([this] { return window().workbench().city() != nullptr; }));
    }
    void TearDown() override {
        renewal.reset();
        applyLanguage(Language::english, *qApp);
        applyUnits(UnitSystem::metric);
    }
    MainWindow& window() { return renewal->window(); }
    void choose(Language language, UnitSystem units) {
        saveLanguage(language, settings);
        saveUnits(units, settings);
        QSignalSpy renewed(renewal.get(), &WindowRenewal::renewed);
        Q_EMIT window().textsChanged();
        ASSERT_TRUE(waitFor([&] { return renewed.size() == 1; }));
    }
};

TEST_F(RenewalTest, AnotherLanguageAndOtherUnitsHoldAtOnceForAllTexts) {
    choose(Language::german, UnitSystem::imperial);
    EXPECT_EQ(window().findChild<QDockWidget*>(QStringLiteral("studyDock"))->windowTitle(),
              QCoreApplication::translate("QObject", "Study"));
    EXPECT_NE(QCoreApplication::translate("QObject", "Results"), QStringLiteral("Results"));
    EXPECT_EQ(window().findChild<QDockWidget*>(QStringLiteral("resultsDock"))->windowTitle(),
              QCoreApplication::translate("QObject", "Results"));
    const auto fields = window().findChildren<LengthField*>();
    ASSERT_FALSE(fields.isEmpty());
    EXPECT_TRUE(fields[0]->textFromValue(10).contains(u'\'')) << fields[0]->textFromValue(10).toStdString();
}

/// All that a widget says: its text, tooltip and entries.
QStringList textsOf(const QWidget& widget) {
    QStringList texts{widget.toolTip()};
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) texts << label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) texts << button->text();
    if (const auto* field = qobject_cast<const QAbstractSpinBox*>(&widget)) texts << field->text();
    if (const auto* list = qobject_cast<const QComboBox*>(&widget))
        for (int i = 0; i < list->count(); ++i) texts << list->itemText(i);
    const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
    const QAbstractItemModel* model = view != nullptr ? view->model() : nullptr;
    for (int column = 0; model != nullptr && column < model->columnCount(); ++column) {
        texts << model->headerData(column, Qt::Horizontal).toString();
        for (int row = 0; row < model->rowCount(); ++row)
            texts << model->index(row, column).data().toString();
    }
    return texts;
}

TEST_F(RenewalTest, NoDockStatesMetresWhereFeetAreChosen) {
    const QRegularExpression metres(QStringLiteral("\\d\\s?(m|m²|km)(?![\\w/])"));
    const auto stated = [&] {
        QStringList found;
        for (const QDockWidget* dock : window().findChildren<QDockWidget*>())
            for (const QWidget* widget : dock->findChildren<QWidget*>())
                for (const QString& text : textsOf(*widget))
                    if (metres.match(text).hasMatch())
                        found << dock->objectName() + QStringLiteral(": ") + text;
        return found;
    };
    EXPECT_FALSE(stated().isEmpty()) << "metres are found where they are";
    choose(Language::english, UnitSystem::imperial);
    EXPECT_EQ(stated().join(u'\n').toStdString(), "");
}

/// Those that Tab reaches in a dock that is in front, in its order.
std::vector<QWidget*> tabOrder(QDockWidget& dock) {
    std::vector<QWidget*> order;
    for (QWidget* next = dock.nextInFocusChain(); next != &dock; next = next->nextInFocusChain())
        if (dock.isAncestorOf(next) && !next->visibleRegion().isEmpty() && next->isEnabled() &&
            (next->focusPolicy() & Qt::TabFocus) != 0)
            order.push_back(next);
    return order;
}

// Down a column, and on to the next one.
TEST_F(RenewalTest, TabGoesDownEveryDockAndAllItReachesHasAName) {
    window().resize(1600, 1100);
    for (QDockWidget* dock : window().findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        ASSERT_TRUE(waitFor([&] { return !dock->visibleRegion().isEmpty(); }))
            << dock->objectName().toStdString();
        const QWidget* before = nullptr;
        for (QWidget* next : tabOrder(*dock)) {
            const std::string name =
                (dock->objectName() + QStringLiteral(": ") + next->objectName()).toStdString() + ", a " +
                next->metaObject()->className();
            QAccessibleInterface* output = QAccessible::queryAccessibleInterface(next);
            ASSERT_NE(output, nullptr) << name;
            EXPECT_FALSE(output->text(QAccessible::Name).isEmpty()) << name;
            const auto place = [&](const QWidget* widget) {
                return QRect(widget->mapTo(dock, QPoint()), widget->size());
            };
            if (before != nullptr) {
                EXPECT_TRUE(place(next).bottom() >= place(before).top() ||
                            place(next).left() > place(before).right())
                    << name << " lies above " << before->objectName().toStdString();
            }
            before = next;
        }
    }
}

TEST_F(RenewalTest, TheWorkStaysWithItsUndoAndItsView) {
    ASSERT_TRUE(
        window().workbench().session().addEdits({test::newTower("New", 70)}, QStringLiteral("tower")));
    ASSERT_TRUE(waitFor([this] { return window().workbench().city()->city().buildings.size() == 4; }));
    CameraPose pose = window().panel().view().pose();
    pose.headingDeg = 77;
    window().panel().view().setPose(pose);
    window().mode().setMode(ViewMode::analysis);
    window().findChild<QDockWidget*>(QStringLiteral("projectDock"))->hide();
    const QPointer<MainWindow> before = &window();
    const Workbench* work = &window().workbench();
    choose(Language::spanish, UnitSystem::metric);
    EXPECT_TRUE(before.isNull());
    EXPECT_EQ(&window().workbench(), work);
    EXPECT_NEAR(window().panel().view().pose().headingDeg, 77, 1e-6);
    EXPECT_EQ(window().mode().mode(), ViewMode::analysis);
    EXPECT_TRUE(window().findChild<QDockWidget*>(QStringLiteral("projectDock"))->isHidden());
    EXPECT_TRUE(window().isWindowModified()) << "unsaved as before";
    window().workbench().document().undoStack().undo();
    EXPECT_TRUE(waitFor([this] { return window().workbench().city()->city().buildings.size() == 3; }));
}

TEST_F(RenewalTest, AResultStaysShown) {
    window().workbench().run();
    ASSERT_TRUE(waitFor([this] { return window().workbench().answer() != nullptr; }));
    choose(Language::german, UnitSystem::metric);
    EXPECT_TRUE(window().workbench().answer());
    EXPECT_TRUE(window().panel().results().showsAnswer() || window().mode().mode() == ViewMode::exploration);
}

TEST_F(RenewalTest, RulesAreInTheNewLanguageAtOnce) {
    const auto choose = [&](const char* rule) {
        ReviewChoice choice = window().review().choice();
        choice.rule = rule;
        choice.options.clear();
        window().review().choose(choice);
    };
    const auto option = [&] {
        const auto* list = window().findChild<QComboBox*>(QStringLiteral("reviewOption"));
        return list == nullptr ? QStringList() : QStringList{list->itemText(1), list->itemData(1).toString()};
    };
    const auto show = [&] {  // the form and the verdicts are filled once they are in sight
        const auto* form = window().findChild<RuleForm*>();
        const auto* verdicts = window().findChild<ReviewDock*>();
        for (QDockWidget* dock : window().findChildren<QDockWidget*>())
            if (dock->isAncestorOf(form) || dock->isAncestorOf(verdicts)) dock->show(), dock->raise();
    };
    show();
    choose("en-17037");
    ASSERT_TRUE(waitFor([&] { return !option().isEmpty(); }));
    EXPECT_EQ(option()[0], option()[1]);
    this->choose(Language::german, UnitSystem::metric);
    show();
    ASSERT_TRUE(waitFor([&] { return !option().isEmpty(); }));
    EXPECT_NE(option()[0], option()[1]) << "the key stays, the option is translated";
    EXPECT_EQ(option()[0], ruleName(option()[1].toStdString()));
    const auto rule = window().review().rule();
    ASSERT_TRUE(rule);
    const QString criterion = ruleName(rule->criteria.front().name);
    EXPECT_NE(criterion, QString::fromStdString(rule->criteria.front().name));
    EXPECT_TRUE(waitFor([&] {
        QString shown;
        for (const QTextEdit* text : window().findChildren<QTextEdit*>()) shown += text->toPlainText();
        return shown.contains(criterion);
    }));
    const auto* rules = window().findChild<QComboBox*>(QStringLiteral("reviewRule"));
    EXPECT_TRUE(rules->currentData(Qt::ToolTipRole).toString().contains(ruleName(rule->summary)));
}

TEST_F(RenewalTest, TheVerdictsOfAReviewStay) {
    ProjectSession& session = window().workbench().session();
    Project next = session.project();
    next.places.push_back({"Yard", PlaceKind::park, {test::square({20, 20}, 30)}, "drawn"});
    ASSERT_TRUE(session.change(std::move(next), QStringLiteral("places")));
    ASSERT_TRUE(session.addEdits({test::newTower("New", 70)}, QStringLiteral("tower")));
    ASSERT_TRUE(waitFor([this] { return window().workbench().city()->city().buildings.size() == 4; }));
    window().review().run();
    ASSERT_TRUE(waitFor([this] { return window().review().shown() != nullptr; }));
    const auto before = window().review().shown();
    choose(Language::german, UnitSystem::metric);
    EXPECT_EQ(window().review().shown(), before);
    EXPECT_TRUE(window().review().whyOutdated().isEmpty()) << window().review().whyOutdated().toStdString();
}

}  // namespace
}  // namespace noonmark
