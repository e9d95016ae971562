#include "app/gui/frame/window_layout.h"

#include <QAccessible>
#include <QAction>
#include <QDockWidget>
#include <QFormLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QMainWindow>
#include <QPointer>
#include <QScrollArea>
#include <QSettings>
#include <QTextDocumentFragment>
#include <QWidget>
#include <algorithm>
#include <glm/common.hpp>
#include <memory>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/docks/contributions/contributions_dock.h"
#include "app/gui/docks/elements/elements_dock.h"
#include "app/gui/docks/places/places_dock.h"
#include "app/gui/docks/point/point_dock.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/docks/review/review_dock.h"
#include "app/gui/docks/review/review_form.h"
#include "app/gui/docks/review/review_session.h"
#include "app/gui/docks/scenarios/scenarios_dock.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/docks/weights/weights_dock.h"
#include "app/gui/frame/actions/view_actions.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/view_presets.h"

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
    QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(&widget);
    return accessible != nullptr && !accessible->text(QAccessible::Name).isEmpty();
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

constexpr int sideWidth = 324;  // with its tabs
constexpr int narrowSideWidth = 290;
constexpr int widthOfThreeSides = 1500;  // of a window that has panels at left, right and below
constexpr int narrowWidth = 190;
constexpr int scrollBarWidth = 22;
constexpr int tabsWidth = 28;              // of names that stand upright beside panels
constexpr int aroundView = 200;            // of the window's height: menus, bars, the strip below the view
constexpr int minLow = 230, maxLow = 300;  // of a dock below the view: a table of some rows beside a chart

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

// A field that does not fit beside its label stands below it, so that no panel scrolls sideways.
void wrapLongRows(const QWidget& content) {
    for (auto* form : content.findChildren<QFormLayout*>()) form->setRowWrapPolicy(QFormLayout::WrapLongRows);
}

QDockWidget* dockOf(const QString& title, const char* name, QWidget* content) {
    wrapLongRows(*content);
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

QString nameOfSide(Qt::DockWidgetArea area) { return QStringLiteral("side%1").arg(int(area)); }

// Hides what is shown there, or shows again what it has hidden.
QAction* makeSideSwitch(QMainWindow& window, Qt::DockWidgetArea area, const QString& text, const char* keys) {
    QAction* action =
        makeAction(&window, text, QKeySequence(QString::fromLatin1(keys)),
                   QObject::tr("Hides these panels, for more of the view, and shows them again"));
    action->setObjectName(nameOfSide(area));
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
    const int studyWidth = docks.study->sizeHint().width() + scrollBarWidth;
    docks.results->setMinimumWidth(narrowWidth);
    QDockWidget* study = dockOf(QObject::tr("Study"), "studyDock", docks.study);
    QDockWidget* results = dockOf(QObject::tr("Results"), "resultsDock", docks.results);
    QDockWidget* warnings = dockOf(QObject::tr("Warnings"), "warningsDock", docks.warnings);
    QDockWidget* project = dockOf(QObject::tr("Project"), "projectDock", docks.project);
    QDockWidget* scenarios =
        dockOf(QObject::tr("Scenarios"), "scenariosDock", scrolled(docks.scenarios, sideWidth));
    QDockWidget* weights = dockOf(QObject::tr("Weights"), "weightsDock", scrolled(docks.weights, sideWidth));
    QDockWidget* building =
        dockOf(QObject::tr("Building"), "buildingDock", scrolled(docks.building, studyWidth));
    QDockWidget* tower = dockOf(QObject::tr("Tower"), "towerDock", docks.tower);
    QDockWidget* trees = dockOf(QObject::tr("Trees"), "treesDock", docks.trees);
    QDockWidget* rule = dockOf(QObject::tr("Review"), "reviewFormDock", docks.reviewForm);
    QDockWidget* review = dockOf(QObject::tr("Verdicts"), "reviewDock", docks.review);
    QDockWidget* point = dockOf(QObject::tr("Point"), "pointDock", docks.point);
    QDockWidget* elements = dockOf(QObject::tr("Facades and points"), "elementsDock", docks.elements);
    QDockWidget* contributions =
        dockOf(QObject::tr("Contributions"), "contributionsDock", scrolled(docks.contributions, sideWidth));
    QDockWidget* places = dockOf(QObject::tr("Places"), "placesDock", docks.places);
    window.setCorner(Qt::BottomRightCorner,
                     Qt::RightDockWidgetArea);  // the sides beside a table keep their height
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.addDockWidget(Qt::BottomDockWidgetArea, review);
    for (QDockWidget* beside : {point, elements}) window.tabifyDockWidget(review, beside);
    window.addDockWidget(Qt::LeftDockWidgetArea, study);
    for (QDockWidget* beside : {rule, project, building, tower, trees, warnings})
        window.tabifyDockWidget(study, beside);
    study->raise();
    // Five names and more, on narrow panels.
    window.setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::West);
    window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::East);
    window.addDockWidget(Qt::RightDockWidgetArea, results);
    for (QDockWidget* beside : {places, contributions, scenarios, weights})
        window.tabifyDockWidget(results, beside);
    QObject::connect(contributions, &QDockWidget::visibilityChanged, docks.contributions,
                     &ContributionsDock::setInFront);
    results->raise();
    // They open when they have something to say, or on wish: the view has their room until then.
    for (QDockWidget* dock :
         {rule, review, point, elements, results, places, contributions, scenarios, weights, warnings, trees})
        dock->hide();
    window.resizeDocks({study}, {studyWidth + tabsWidth}, Qt::Horizontal);
    QList<QAction*> toggles;
    for (QDockWidget* dock : {project, study, results, contributions, scenarios, weights, places, rule,
                              review, point, elements, building, tower, trees, warnings}) {
        toggles << dock->toggleViewAction();
        QObject::connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool shown) {
            if (shown) dock->raise();
        });
    }
    return toggles;
}

namespace {

// A panel that opens below hides those at the right in a narrow window; their switch shows them again.
void makeRoomBelow(QMainWindow& window) {
    if (window.width() >= widthOfThreeSides || shownAt(window, Qt::RightDockWidgetArea).isEmpty()) return;
    if (auto* side = window.findChild<QAction*>(nameOfSide(Qt::RightDockWidgetArea))) side->trigger();
}

// The height of a panel below that leaves half of the window to the view, on low screens less.
int heightBelow(const QMainWindow& window) {
    return std::clamp(window.height() / 2 - aroundView, minLow, maxLow);
}

// The width of a panel at the right that leaves half of the window to the view.
int widthAtRight(const QMainWindow& window) {
    int left = 0;
    for (const auto& dock : shownAt(window, Qt::LeftDockWidgetArea)) left = std::max(left, dock->width());
    return std::clamp(window.width() / 2 - left, narrowSideWidth, sideWidth);
}

}  // namespace

void openDock(QMainWindow& window, QDockWidget& dock, DockPlace place) {
    const Qt::DockWidgetArea area = window.dockWidgetArea(&dock);
    const bool isFirst = !dock.isFloating() && shownAt(window, area).isEmpty();
    const bool isAside = isFirst && place == DockPlace::behindOthers && area == Qt::RightDockWidgetArea;
    if (isAside && window.width() < widthOfThreeSides && !shownAt(window, Qt::BottomDockWidgetArea).isEmpty())
        return;  // the panel below has its answer
    if (isFirst && area == Qt::BottomDockWidgetArea) makeRoomBelow(window);
    dock.show();
    if (place == DockPlace::inFront) dock.raise();
    if (isFirst && area == Qt::BottomDockWidgetArea)
        window.resizeDocks({&dock}, {heightBelow(window)}, Qt::Vertical);
    if (isFirst && area == Qt::RightDockWidgetArea)
        window.resizeDocks({&dock}, {widthAtRight(window)}, Qt::Horizontal);
}

QList<QAction*> makeSideSwitches(QMainWindow& window) {
    return {makeSideSwitch(window, Qt::LeftDockWidgetArea, QObject::tr("Panels at the left"), "F8"),
            makeSideSwitch(window, Qt::RightDockWidgetArea, QObject::tr("Panels at the right"), "F9"),
            makeSideSwitch(window, Qt::BottomDockWidgetArea, QObject::tr("Panels below"), "Shift+F9")};
}

namespace {

const QString shownKey = QStringLiteral("legendShow"), placesShownKey = QStringLiteral("placesShow");

ShownAs lastShown(const QSettings& settings, const QString& of, ShownAs usual) {
    const std::string key = settings.value(of).toString().toStdString();
    return findChoice(shownChoices(), key).value_or(usual);
}

void remember(QSettings& settings, const QString& of, ShownAs shown) {
    const std::string_view key = keyOf(shownChoices(), shown);
    settings.setValue(of, QString::fromUtf8(key.data(), qsizetype(key.size())));
}

// The region with ground around it; of a city that is smaller than that only the city with some ground.
Box2 firstSight(const Region& region, const Box2& city) {
    const Box2 wide = boxAround(region);
    const glm::vec2 border = (city.high - city.low) * 0.2F;
    const Box2 seen{glm::max(wide.low, city.low - border), glm::min(wide.high, city.high + border)};
    return seen.empty() ? wide : seen;
}

}  // namespace

void WindowView::rememberShown() {
    remember(settings_, shownKey, panel_.legend().choice().show);
    remember(settings_, placesShownKey, panel_.legend().shownOfPlaces());
}

std::map<std::string, std::string> WindowView::toSave() const {
    const ProjectSession& session = workbench_.session();
    ViewState state{.camera = panel_.view().pose(),
                    .section = panel_.view().section(),
                    .mode = mode_.mode(),
                    .measure = panel_.legend().measure(),
                    .changeScale = panel_.legend().changeScale(),
                    .legend = panel_.legend().choice(),
                    .scenario = session.scenario(),
                    .baseline = session.baseline(),
                    .study = workbench_.document().settings(),
                    .elements = workbench_.document().elements(),
                    .review = formatText(review_.choice())};
    if (const auto answer = workbench_.answer(); answer && answer->question().ofRun) {
        state.answer = answer->as<ImpactAnswer>() ? "comparison" : "study";
        state.answerSeconds = workbench_.answerSeconds();
    }
    if (const auto measured = workbench_.measuredShown()) state.shown = measured->name();
    return textsOf(state);
}

void WindowView::restore() { restore(workbench_.openedView()); }

void WindowView::restore(const ViewState& view) {
    review_.restore(view.review);
    panel_.legend().setShownOfPlaces(lastShown(settings_, placesShownKey, ShownAs::sun));
    if (workbench_.session().file() || &view != &workbench_.openedView()) {
        mode_.setMode(view.mode);
        panel_.legend().setMeasure(view.measure);
        panel_.legend().setChoice(view.legend);
    } else {
        panel_.legend().setChoice({.show = lastShown(settings_, shownKey, ShownAs::shadow)});
    }
    panel_.legend().setChangeScale(view.changeScale);
    panel_.section().set(view.section);
    if (view.camera)
        panel_.view().setPose(*view.camera);
    else
        panel_.navigator().showSlanting(
            firstSight(workbench_.document().settings().region, panel_.view().mainBounds().box));
}

}  // namespace noonmark
