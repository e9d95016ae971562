#include "app/gui/base/widgets/error_text.h"

#include <QCoreApplication>
#include <QObject>
#include <QStringList>
#include <algorithm>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "app/gui/base/looks/language.h"
#include "core/base/safe_text.h"
#include "generated/translation_contexts.h"

namespace noonmark {

namespace {

// What the window reports by itself.
[[maybe_unused]] constexpr const char* errorWords[] = {
    QT_TRANSLATE_NOOP("Error", "No city is open"),
    QT_TRANSLATE_NOOP("Error", "Open a file or a sample first"),
    QT_TRANSLATE_NOOP("Error", "This result is already saved"),
    QT_TRANSLATE_NOOP("Error", "Another result is being saved"),
    QT_TRANSLATE_NOOP("Error", "Wait until it is saved"),
    QT_TRANSLATE_NOOP("Error", "There is no result to save"),
    QT_TRANSLATE_NOOP("Error", "There is no result to export"),
    QT_TRANSLATE_NOOP("Error", "There are no figures to copy"),
    QT_TRANSLATE_NOOP("Error", "Press Run first"),
    QT_TRANSLATE_NOOP("Error", "The file was not opened: the project was changed while it was read"),
    QT_TRANSLATE_NOOP("Error", "Save or undo the change, then open the file again"),
    QT_TRANSLATE_NOOP("Error", "The file holds no such places near the city"),
    QT_TRANSLATE_NOOP("Error", "Choose a map of this city with parks or streets, or a file of polygons"),
    QT_TRANSLATE_NOOP("Error", "The project has no place of this name any more"),
    QT_TRANSLATE_NOOP("Error", "Run again, so that the table lists the places as they are"),
    QT_TRANSLATE_NOOP("Error", "The picture could not be written"),
    QT_TRANSLATE_NOOP("Error", "Choose another folder"),
    QT_TRANSLATE_NOOP("Error", "No ground of the city is visible"),
    QT_TRANSLATE_NOOP("Error", "Move the view to the city first"),
    QT_TRANSLATE_NOOP("Error", "The project has no lots, and this rule is about parcels"),
    QT_TRANSLATE_NOOP("Error", "Draw the lot of the proposal: Edit > Draw lot"),
    QT_TRANSLATE_NOOP("Error", "The project has no places yet"),
    QT_TRANSLATE_NOOP("Error", "Read them from a map or draw one: Study > Read places, Study > Draw place"),
    QT_TRANSLATE_NOOP("Error", "No place is chosen"),
    QT_TRANSLATE_NOOP("Error", "The proposal's shadow reaches no place in the rule's hours"),
    QT_TRANSLATE_NOOP("Error", "Review all places to have that stated for each"),
    QT_TRANSLATE_NOOP("Error",
                      "Tick the places to review, or press In reach to find those that the shadow reaches"),
    QT_TRANSLATE_NOOP("Error", "Design a tower, or choose a scenario with a proposal"),
    QT_TRANSLATE_NOOP("Error", "The building is still being designed"),
    QT_TRANSLATE_NOOP("Error", "Build it, then run the review"),
    QT_TRANSLATE_NOOP("Error", "There is no review to export"),
    QT_TRANSLATE_NOOP("Error", "Press Run review first"),
    QT_TRANSLATE_NOOP("Error", "Check place and year"),
    QT_TRANSLATE_NOOP("Error", "The sides of the lot cross each other"),
    QT_TRANSLATE_NOOP("Error", "Draw the corners in order around the lot"),
    QT_TRANSLATE_NOOP("Error", "The sides of the lot would cross or touch each other"),
    QT_TRANSLATE_NOOP("Error", "Move the corner or side less far"),
    QT_TRANSLATE_NOOP("Error", "The sides beside it meet before that"),
    QT_TRANSLATE_NOOP("Error", "Move the side less far"),
    QT_TRANSLATE_NOOP("Error", "A lot needs three corners or more"),
    QT_TRANSLATE_NOOP("Error", "Move the corner instead"),
    QT_TRANSLATE_NOOP("Error", "No corner is selected"),
    QT_TRANSLATE_NOOP("Error", "Click a corner of the lot, then press Delete"),
    QT_TRANSLATE_NOOP("Error", "The direction of the side is not known"),
    QT_TRANSLATE_NOOP("Error", "Move the cursor to where the side leads, or type an azimuth: 40<90"),
    QT_TRANSLATE_NOOP("Error", "This is not a length"),
    QT_TRANSLATE_NOOP("Error", "Type it as 40, 40 m or 131' 3\", with an azimuth as 40<90"),
    QT_TRANSLATE_NOOP("Error", "The polygon has no area"),
    QT_TRANSLATE_NOOP("Error", "Draw it again with corners farther apart"),
    QT_TRANSLATE_NOOP("Error", "Click more corners, or press Esc"),
    QT_TRANSLATE_NOOP("Error", "There is no region or place of this name"),
    QT_TRANSLATE_NOOP("Error", "Choose one from the list"),
    QT_TRANSLATE_NOOP("Error", "The folder holds no buildings"),
    QT_TRANSLATE_NOOP("Error", "Choose a folder of footprints, city models or meshes"),
    QT_TRANSLATE_NOOP("Error", "The city has a terrain already"),
    QT_TRANSLATE_NOOP("Error", "Open the city without it first"),
    QT_TRANSLATE_NOOP("Error",
                      "A terrain can be added to city files only, before they are saved as a project"),
    QT_TRANSLATE_NOOP("Error", "Open the city files and the terrain together"),
    QT_TRANSLATE_NOOP("Error", "The city has an aerial photograph already"),
    QT_TRANSLATE_NOOP("Error", "Remove it first: File > Aerial photograph"),
    QT_TRANSLATE_NOOP("Error", "Some scenarios could not be computed"),
    QT_TRANSLATE_NOOP("Error", "The panel Scenarios says why in the row of each")};

// Of nameOf(WarningKind), which lies below the macro of core.
[[maybe_unused]] constexpr const char* warningKinds[] = {
    QT_TRANSLATE_NOOP("noonmark", "repaired"), QT_TRANSLATE_NOOP("noonmark", "clipped"),
    QT_TRANSLATE_NOOP("noonmark", "dropped"),  QT_TRANSLATE_NOOP("noonmark", "left out"),
    QT_TRANSLATE_NOOP("noonmark", "assumed"),  QT_TRANSLATE_NOOP("noonmark", "duplicates")};

}  // namespace

namespace {

QString findTranslated(const std::string& source) {
    const QString english = QString::fromStdString(source);
    for (const char* context : translationContexts)
        if (QString found = QCoreApplication::translate(context, source.c_str()); found != english)
            return found;
    return english;
}

/// A text is looked for in all contexts, and one that is its own translation in vain: tables ask for the same
/// names at each comparison of two rows.
struct KnownTexts {
    static constexpr std::size_t maxTexts = 100'000;
    std::mutex mutex;
    std::unordered_map<std::string, QString> texts;
    int languageChanges = 0;
};

KnownTexts& knownTexts() {
    static KnownTexts known;
    return known;
}

}  // namespace

QString translated(std::string_view text) {
    if (text.empty()) return {};
    std::string source(text);
    KnownTexts& known = knownTexts();
    const std::scoped_lock lock(known.mutex);
    const bool isOtherLanguage =
        std::exchange(known.languageChanges, countLanguageChanges()) != countLanguageChanges();
    if (isOtherLanguage || known.texts.size() >= KnownTexts::maxTexts) known.texts.clear();
    if (const auto found = known.texts.find(source); found != known.texts.end()) return found->second;
    QString found = findTranslated(source);
    return known.texts.emplace(std::move(source), std::move(found)).first->second;
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
    Error all{"Some scenarios could not be computed", {}, "The panel Scenarios says why in the row of each"};
    if (same) all = errors.front().second;
    std::string names;
    for (const auto& [scenario, error] : errors) names += (names.empty() ? "" : ", ") + scenario;
    all.where = all.where.empty() ? names : names + ", " + all.where;
    return all;
}

}  // namespace noonmark
