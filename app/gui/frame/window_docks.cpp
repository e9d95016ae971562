#include "app/gui/frame/window_docks.h"

#include <QAccessible>
#include <QDockWidget>
#include <QGroupBox>
#include <QLineEdit>
#include <QMainWindow>
#include <QPointer>
#include <QScrollArea>
#include <QTextDocumentFragment>
#include <QWidget>
#include <memory>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/docks/contributions/contributions_dock.h"
#include "app/gui/docks/elements/elements_dock.h"
#include "app/gui/docks/places/places_dock.h"
#include "app/gui/docks/point/point_dock.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/docks/review/review_dock.h"
#include "app/gui/docks/scenarios/scenarios_dock.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/docks/weights/weights_dock.h"

namespace noonmark {

namespace {

QString plainLine(const QString& text) {
    const QString plain =
        Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
    return plain.section(QLatin1Char('\n'), 0, 0);
}

QString titleAround(const QWidget& widget) {
    for (const QWidget* around = widget.parentWidget(); around != nullptr; around = around->parentWidget()) {
        if (const auto* box = qobject_cast<const QGroupBox*>(around)) return box->title();
        if (!around->accessibleName().isEmpty()) return around->accessibleName();
        if (!around->windowTitle().isEmpty()) return around->windowTitle();
    }
    return {};
}

bool hasName(QWidget& widget) {
    QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(&widget);
    return spoken != nullptr && !spoken->text(QAccessible::Name).isEmpty();
}

QString findName(const QWidget& widget) {
    if (const QString tip = plainLine(widget.toolTip()); !tip.isEmpty()) return tip;
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget);
        line && !line->placeholderText().isEmpty())
        return line->placeholderText();
    return titleAround(widget);
}

}  // namespace

void nameForScreenReaders(QWidget& window) {
    for (QWidget* widget : window.findChildren<QWidget*>())
        if (widget->focusPolicy() != Qt::NoFocus && !hasName(*widget))
            widget->setAccessibleName(findName(*widget));
}

namespace {

constexpr int sideWidth = 330;  // four tabs with their names
constexpr int narrowWidth = 190;
constexpr int scrollBarWidth = 22;
constexpr int reviewHeight = 300;

// Wraps the content in a scroll area, so that a dock can be smaller than its content.
QScrollArea* scrolled(QWidget* content, int minWidth) {
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    content->setMinimumWidth(minWidth - scrollBarWidth);
    scroll->setMinimumWidth(narrowWidth);  // on a small screen it also scrolls horizontally
    return scroll;
}

QDockWidget* dockOf(const QString& title, const char* name, QWidget* content) {
    auto* dock = new QDockWidget(title);
    dock->setObjectName(QString::fromLatin1(name));  // the saved layout identifies docks by object name
    dock->setWidget(content);
    return dock;
}

QList<QPointer<QDockWidget>> shownAt(const QMainWindow& window, Qt::DockWidgetArea area) {
    QList<QPointer<QDockWidget>> shown;
    for (QDockWidget* dock : window.findChildren<QDockWidget*>())
        if (window.dockWidgetArea(dock) == area && !dock->isHidden() && !dock->isFloating()) shown << dock;
    return shown;
}

// Hides what is shown there, or shows again what it has hidden.
QAction* makeSideSwitch(QMainWindow& window, Qt::DockWidgetArea area, const QString& text, const char* keys) {
    QAction* action =
        makeAction(&window, text, QKeySequence(QString::fromLatin1(keys)),
                   QObject::tr("Hides these panels, for more of the view, and shows them again"));
    action->setObjectName(QStringLiteral("side%1").arg(int(area)));
    auto hidden = std::make_shared<QList<QPointer<QDockWidget>>>();
    QObject::connect(action, &QAction::triggered, &window, [&window, area, hidden] {
        const auto shown = shownAt(window, area);
        for (const auto& dock : shown) dock->hide();
        for (const auto& dock : shown.isEmpty() ? *hidden : QList<QPointer<QDockWidget>>())
            if (dock) dock->show();
        *hidden = shown;
    });
    return action;
}

}  // namespace

QList<QAction*> placeDocks(QMainWindow& window, const WindowDocks& docks) {
    const int studyWidth = docks.study->sizeHint().width() + 22;
    docks.results->setMinimumWidth(narrowWidth);
    QDockWidget* study = dockOf(QObject::tr("Study"), "studyDock", docks.study);
    QDockWidget* results = dockOf(QObject::tr("Results"), "resultsDock", docks.results);
    QDockWidget* warnings = dockOf(QObject::tr("Warnings"), "warningsDock", docks.warnings);
    QDockWidget* project = dockOf(QObject::tr("Project"), "projectDock", docks.project);
    QDockWidget* scenarios = dockOf(QObject::tr("Scenarios"), "scenariosDock", docks.scenarios);
    QDockWidget* weights = dockOf(QObject::tr("Weights"), "weightsDock", scrolled(docks.weights, sideWidth));
    QDockWidget* building =
        dockOf(QObject::tr("Building"), "buildingDock", scrolled(docks.building, studyWidth));
    QDockWidget* tower = dockOf(QObject::tr("Tower"), "towerDock", docks.tower);
    QDockWidget* review = dockOf(QObject::tr("Review"), "reviewDock", docks.review);
    QDockWidget* point = dockOf(QObject::tr("Point"), "pointDock", docks.point);
    QDockWidget* elements = dockOf(QObject::tr("Facades and points"), "elementsDock", docks.elements);
    QDockWidget* contributions =
        dockOf(QObject::tr("Contributions"), "contributionsDock", scrolled(docks.contributions, sideWidth));
    QDockWidget* places = dockOf(QObject::tr("Places"), "placesDock", docks.places);
    window.setCorner(Qt::BottomRightCorner,
                     Qt::RightDockWidgetArea);  // Results beside a table keep their height
    window.addDockWidget(Qt::BottomDockWidgetArea, review);
    for (QDockWidget* beside : {point, elements, places}) window.tabifyDockWidget(review, beside);
    for (QDockWidget* dock : {review, point, elements, places})
        dock->hide();  // they take much of the view's height
    window.addDockWidget(Qt::LeftDockWidgetArea, study);
    for (QDockWidget* beside : {building, tower}) window.tabifyDockWidget(study, beside);
    study->raise();
    window.addDockWidget(Qt::RightDockWidgetArea, project);
    window.addDockWidget(Qt::RightDockWidgetArea, results);
    for (QDockWidget* beside : {contributions, scenarios, weights}) window.tabifyDockWidget(results, beside);
    QObject::connect(contributions, &QDockWidget::visibilityChanged, docks.contributions,
                     &ContributionsDock::setInFront);
    window.addDockWidget(Qt::RightDockWidgetArea, warnings);
    results->raise();
    window.resizeDocks({project, results, warnings}, {180, 470, 90}, Qt::Vertical);
    window.resizeDocks({study, project}, {studyWidth, sideWidth}, Qt::Horizontal);
    QList<QAction*> toggles;
    window.resizeDocks({review}, {reviewHeight}, Qt::Vertical);
    for (QDockWidget* dock : {project, study, results, contributions, scenarios, weights, places, review,
                              point, elements, building, tower, warnings})
        toggles << dock->toggleViewAction();
    return toggles;
}

QList<QAction*> makeSideSwitches(QMainWindow& window) {
    return {makeSideSwitch(window, Qt::LeftDockWidgetArea, QObject::tr("Panels at the left"), "F8"),
            makeSideSwitch(window, Qt::RightDockWidgetArea, QObject::tr("Panels at the right"), "F9"),
            makeSideSwitch(window, Qt::BottomDockWidgetArea, QObject::tr("Panels below"), "Shift+F9")};
}

}  // namespace noonmark
