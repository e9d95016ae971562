#include "app/gui/base/widgets/qt_dates.h"

#include <QObject>

namespace noonmark {

QString shortDay() { return QObject::tr("d MMM"); }
QString longDay() { return QObject::tr("d MMMM"); }
QString dayOfYear() { return QObject::tr("d MMM yyyy"); }
QString longDate() { return QObject::tr("d MMMM yyyy"); }

QDate dateOf(CivilDate date) {
    return {int(date.year()), int(unsigned(date.month())), int(unsigned(date.day()))};
}

CivilDate civilOf(QDate date) {
    return {std::chrono::year{date.year()}, std::chrono::month{unsigned(date.month())},
            std::chrono::day{unsigned(date.day())}};
}

}  // namespace noonmark
