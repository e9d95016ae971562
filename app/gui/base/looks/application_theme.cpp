#include "app/gui/base/looks/application_theme.h"

#include <QActionGroup>
#include <QApplication>
#include <QEvent>
#include <QPainter>
#include <QSettings>
#include <QStyleFactory>
#include <QStyleOption>
#include <QToolButton>
#include <utility>

#include "app/gui/base/looks/theme.h"

namespace noonmark {

ApplicationTheme::ApplicationTheme(QApplication& application, ThemeChoice choice, const QPalette& system,
                                   std::unique_ptr<ThemeSource> desktop)
    : QObject(&application), choice_(choice), system_(system), desktop_(std::move(desktop)) {
    application.installEventFilter(this);
    if (desktop_) connect(desktop_.get(), &ThemeSource::changed, this, &ApplicationTheme::apply);
    apply();
}

ApplicationTheme* ApplicationTheme::inUse() {
    return qApp->findChild<ApplicationTheme*>(QString(), Qt::FindDirectChildrenOnly);
}

void ApplicationTheme::choose(ThemeChoice choice) {
    choice_ = choice;
    apply();
}

// The platform tells each window; one answer is enough.
bool ApplicationTheme::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::ThemeChange && !std::exchange(paletteChanged_, true))
        QMetaObject::invokeMethod(this, &ApplicationTheme::readPalette, Qt::QueuedConnection);
    return false;
}

// The platform's palette shows only while the application has none of its own.
void ApplicationTheme::readPalette() {
    paletteChanged_ = false;
    QApplication::setPalette(QPalette());
    system_ = QApplication::palette();
    apply();
}

void ApplicationTheme::apply() {
    const auto stated = desktop_ ? desktop_->theme() : std::nullopt;
    applyTheme(choice_, stated ? makePalette(*stated) : system_);
}

ThemeMenu::ThemeMenu(QSettings& settings, QWidget* parent) : QMenu(tr("C&olours"), parent) {
    auto* group = new QActionGroup(this);
    for (const auto& [choice, name] :
         {std::pair{ThemeChoice::system, tr("As the &system")}, std::pair{ThemeChoice::light, tr("&Light")},
          std::pair{ThemeChoice::dark, tr("&Dark")}}) {
        QAction* action = group->addAction(name);
        action->setCheckable(true);
        connect(this, &QMenu::aboutToShow, action, [action, choice = choice, &settings] {
            action->setChecked(choice == readThemeChoice(settings));
        });
        connect(action, &QAction::triggered, this, [choice = choice, &settings] {
            saveThemeChoice(choice, settings);
            if (auto* theme = ApplicationTheme::inUse()) theme->choose(choice);
        });
    }
    addActions(group->actions());
}

namespace {

QPen outlinePen(const QPalette& palette, bool enabled) {
    QColor colour = palette.color(enabled ? QPalette::Active : QPalette::Disabled, QPalette::WindowText);
    colour.setAlphaF(enabled ? 0.55F : 0.35F);
    return {colour, 1};
}

}  // namespace

namespace {

// Of a button that is pressed and stays so; not of a heading whose arrow shows whether it is open.
bool isPressedIn(QStyle::PrimitiveElement element, const QStyleOption& option, const QWidget* widget) {
    const bool isButton = element == QStyle::PE_PanelButtonCommand || element == QStyle::PE_PanelButtonTool;
    const auto* tool = qobject_cast<const QToolButton*>(widget);
    return isButton && option.state.testFlag(QStyle::State_On) &&
           (tool == nullptr || tool->arrowType() == Qt::NoArrow);
}

// Over the style's own, which in dark colours hardly differs from one that is not pressed.
void paintPressedIn(const QStyleOption& option, QPainter& painter) {
    constexpr float tint = 0.5F;
    QColor fill = option.palette.color(QPalette::Highlight);
    const QPen edge(fill, 1.5);
    fill.setAlphaF(tint);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(edge);
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(1, 1, -1, -1), 2, 2);
    painter.restore();
}

}  // namespace

WindowStyle::WindowStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void WindowStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (isPressedIn(element, *option, widget)) paintPressedIn(*option, *painter);
    const bool round = element == PE_IndicatorRadioButton;
    if (!round && element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck) return;
    if (themeOf(option->palette) == Theme::light) return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    painter->setPen(outlinePen(option->palette, option->state.testFlag(State_Enabled)));
    const QRectF box = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    round ? painter->drawEllipse(box) : painter->drawRect(box);
    painter->restore();
}

int WindowStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* answer) const {
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
    if (hint == SH_TabBar_ElideMode)
        return Qt::ElideNone;  // narrow docks scroll their tabs, names stay whole
    return QProxyStyle::styleHint(hint, option, widget, answer);
}

}  // namespace noonmark
