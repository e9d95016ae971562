#include "app/gui/base/widgets/error_text.h"

#include <QCoreApplication>
#include <QObject>
#include <QStringList>
#include <algorithm>

#include "core/base/safe_text.h"

namespace noonmark {

namespace {

// Of nameOf(WarningKind), which lies below the macro of core.
[[maybe_unused]] constexpr const char* warningKinds[] = {
    QT_TRANSLATE_NOOP("noonmark", "repaired"), QT_TRANSLATE_NOOP("noonmark", "clipped"),
    QT_TRANSLATE_NOOP("noonmark", "dropped"),  QT_TRANSLATE_NOOP("noonmark", "left out"),
    QT_TRANSLATE_NOOP("noonmark", "assumed"),  QT_TRANSLATE_NOOP("noonmark", "duplicates")};

}  // namespace

Error noCityError() {
    return {QT_TRANSLATE_NOOP("Error", "No city is open"),
            {},
            QT_TRANSLATE_NOOP("Error", "Open a file or a sample first")};
}

QString describeError(const Error& error) {
    Error local = error;
    local.what = translated(error.what).toStdString();
    local.advice = translated(error.advice).toStdString();
    return QString::fromStdString(local.text());
}

QString describeWarning(const WarningGroup& group) {
    return QObject::tr("%1 %2: %3")
        .arg(group.where.size())
        .arg(translated(nameOf(group.kind)), translated(group.what));
}

QString describeWarningWithPlaces(const WarningGroup& group, std::size_t maximum) {
    QStringList places;
    for (std::size_t i = 0; i < std::min(maximum, group.where.size()); ++i)
        places << QString::fromStdString(cleanText(group.where[i]));
    if (maximum < group.where.size()) places << QStringLiteral("...");
    return QStringLiteral("%1 (%2)").arg(describeWarning(group), places.join(QStringLiteral(", ")));
}

Error sumUp(const ScenarioErrors& errors, std::size_t asked) {
    const auto textOf = [](const auto& one) { return one.second.text(); };
    const bool same =
        std::ranges::all_of(errors, [&](const auto& one) { return textOf(one) == textOf(errors.front()); });
    if (same && errors.size() == asked) return errors.front().second;
    Error all{QT_TRANSLATE_NOOP("Error", "Some scenarios could not be computed"),
              {},
              QT_TRANSLATE_NOOP("Error", "The panel Scenarios says why in the row of each")};
    if (same) all = errors.front().second;
    std::string names;
    for (const auto& [scenario, error] : errors) names += (names.empty() ? "" : ", ") + scenario;
    all.where = all.where.empty() ? names : names + ", " + all.where;
    return all;
}

}  // namespace noonmark
