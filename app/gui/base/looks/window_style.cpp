#include "app/gui/base/looks/window_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include "app/gui/base/looks/theme.h"

namespace noonmark {

namespace {

QPen outlinePen(const QPalette& palette, bool enabled) {
    QColor colour = palette.color(enabled ? QPalette::Active : QPalette::Disabled, QPalette::WindowText);
    colour.setAlphaF(enabled ? 0.55F : 0.35F);
    return {colour, 1};
}

}  // namespace

WindowStyle::WindowStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void WindowStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
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
