#include "app/gui/view/time/time_look.h"

#include <QLocale>

#include "app/gui/base/widgets/qt_dates.h"

namespace noonmark {

Period periodOf(const TimeLook& look, const Period& study) {
    Period period = study;
    if (look.span == LookSpan::period) return period;
    period.start = look.date;
    period.days = 1;
    if (look.span == LookSpan::day) return period;
    period.window.reset();
    period.from = look.at;
    period.hours = 0;
    return period;
}

TimeLook firstLook(const Period& study) {
    TimeLook look{LookSpan::period, study.start};
    const auto middle = study.from + std::chrono::minutes(int(study.hours * 30));
    if (!study.window && middle <= std::chrono::hours(24)) look.at = middle;
    return look;
}

QString describe(const TimeLook& look) {
    if (look.span == LookSpan::period) return {};
    const QString date = QLocale().toString(dateOf(look.date), longDate());
    if (look.span == LookSpan::day) return date;
    return QStringLiteral("%1, %2").arg(date, QString::fromStdString(formatText(look.at)));
}

}  // namespace noonmark
