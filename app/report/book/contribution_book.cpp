#include "app/report/book/contribution_book.h"

#include <algorithm>

#include "app/report/book/flow.h"
#include "app/report/sheets/period_words.h"
#include "core/city/footprints/plan_lines.h"
#include "core/study/contributions/contributions.h"
#include "core/study/text/breakdown_text.h"

namespace noonmark {

namespace {

constexpr std::size_t maxMarks = 30, maxBars = 12;
constexpr double minShare = 0.001;  // of all shadow, of a building that has a row
constexpr double rowPt = 7.8;
constexpr double minutesPerHour = 60;

/// A row of the table: a building, the other buildings or the terrain, m2 h.
struct Contribution {
    QString name;
    double attributedM2h = 0, soleM2h = 0;
};

struct Contributions {
    std::vector<Contribution> buildings;  ///< of the least share and more, the largest first
    std::vector<MapMark> marks;
    Contribution others;
    std::size_t otherCount = 0;
    std::optional<Contribution> terrain;
    double allM2h = 0;
};

Contribution makeContribution(QString name, const BuildingShadow& shadow) {
    return {std::move(name), sumOf(shadow.attributedMinM2) / minutesPerHour,
            sumOf(shadow.soleMinM2) / minutesPerHour};
}

QString nameBuilding(const Building& building, std::uint32_t index) {
    if (!building.name.empty()) return plainText(building.name);
    if (!building.sourceId.empty()) return plainText(building.sourceId);
    return QStringLiteral("building %1").arg(index);
}

/// On the building's largest part.
MapMark makeMark(const Building& building, std::size_t number) {
    const Part& largest =
        *std::ranges::max_element(building.parts, {}, [](const Part& part) { return area(part.footprint); });
    return {findPointInside(largest.footprint), QString::number(number)};
}

double sumOfAll(const ShadowBreakdown& breakdown) {
    double all = breakdown.terrain ? sumOf(breakdown.terrain->attributedMinM2) : 0;
    for (const BuildingShadow& shadow : breakdown.buildings) all += sumOf(shadow.attributedMinM2);
    return all / minutesPerHour;
}

Contributions collectContributions(const Study& study) {
    const ShadowBreakdown& breakdown = *study.breakdown;
    Contributions all;
    all.allM2h = sumOfAll(breakdown);
    for (const BuildingShadow& shadow : sortContributions(breakdown)) {
        const Building& building = *study.city.buildings[shadow.building];
        Contribution one = makeContribution(nameBuilding(building, shadow.building), shadow);
        if (one.attributedM2h < minShare * all.allM2h) {
            all.others.attributedM2h += one.attributedM2h;
            ++all.otherCount;
            continue;
        }
        all.buildings.push_back(std::move(one));
        if (all.marks.size() < maxMarks) all.marks.push_back(makeMark(building, all.buildings.size()));
    }
    if (breakdown.terrain) all.terrain = makeContribution(QStringLiteral("Terrain"), *breakdown.terrain);
    return all;
}

QString describeWhenAndWhere(const Study& study) {
    return describePeriod(study.settings.period) + QStringLiteral(". ") +
           plainText(study.settings.region.name) + QStringLiteral(", ") +
           describePlace(study.settings.region, study.city.frame);
}

BookPage makeNumberedMapPage(const Study& study, const Contributions& all, const BookSettings& settings) {
    const QString title = QStringLiteral("Contributions of buildings");
    const Legend legend = makeLegend(study.field, ShadowMeasure::gross, settings.legend);
    SheetMap map{makeGrossScene(study.city, study.settings.region, study.field, coloursOf(legend)), legend};
    const QString name = legend.title;
    map.scene.marks = all.marks;
    BookPage page{title, describeWhenAndWhere(study), QStringLiteral("Map"), 0, {}};
    page.items.push_back(
        {contentArea(settings.setup),
         PageMap{std::make_shared<const SheetMap>(std::move(map)),
                 {QStringLiteral("%1 and the buildings that make most of the shadow").arg(name),
                  QStringLiteral("Numbers as in the table; buildings outside of the map are not shown")}}});
    return page;
}

BookPage makeBarPage(const Contributions& all, const BookSettings& settings) {
    const QString title = QStringLiteral("Largest contributions");
    BarChart chart{
        {{QStringLiteral("Attributed"), shade::proposal}, {QStringLiteral("Sole"), shade::incremental}},
        {},
        true,
        settings.units};
    for (std::size_t i = 0; i < std::min(maxBars, all.buildings.size()); ++i)
        chart.groups.push_back(
            {QString::number(i + 1), {all.buildings[i].attributedM2h, all.buildings[i].soleM2h}});
    QRectF area = contentArea(settings.setup);
    area.setHeight(area.height() / 2);
    BookPage page{title, {}, title, 0, {}};
    page.items.push_back({area, PageChart{std::move(chart),
                                          {QStringLiteral("Area x hours in shadow, by building"),
                                           QStringLiteral("Numbers as in the table")}}});
    return page;
}

std::vector<QString> makeShareRow(const QString& number, const Contribution& one, bool hasSole, double allM2h,
                                  UnitSystem units) {
    const auto hours = [units](double m2h) { return QString::fromStdString(formatAreaHours(m2h, units)); };
    const double percent = allM2h > 0 ? 100 * one.attributedM2h / allM2h : 0;
    return {number, one.name, describeAmount(percent, 2) + QStringLiteral(" %"), hours(one.attributedM2h),
            hasSole ? hours(one.soleM2h) : QString()};
}

PageTable makeTable(const Contributions& all, const BookSettings& settings) {
    PageTable table{{QStringLiteral("No."), QStringLiteral("Building"), QStringLiteral("Share of all shadow"),
                     QStringLiteral("Attributed"), QStringLiteral("Sole")},
                    {},
                    {},
                    {},
                    rowPt * textScale(settings.setup)};
    const auto add = [&](const QString& number, const Contribution& one, bool hasSole) {
        table.rows.push_back(makeShareRow(number, one, hasSole, all.allM2h, settings.units));
    };
    for (std::size_t i = 0; i < all.buildings.size(); ++i)
        add(QString::number(i + 1), all.buildings[i], true);
    if (all.otherCount > 0) {
        Contribution others = all.others;
        others.name = QStringLiteral("Other buildings: %1").arg(describeCount(all.otherCount));
        add({}, others, false);
    }
    if (all.terrain) add({}, *all.terrain, true);
    add({}, {QStringLiteral("All shadow"), all.allM2h}, false);
    return table;
}

std::vector<BookPage> makeShareTablePages(const Study& study, const Contributions& all,
                                          const BookSettings& settings) {
    const QString title = QStringLiteral("Contributions"),
                  note = QStringLiteral(
                             "Attributed: %1. Sole: %2. Area x hours over the whole period. Engine: %3. "
                             "Rows below 0.1 % are added up; contributions.csv lists each.")
                             .arg(plainText(std::string(attributedDefinition())),
                                  plainText(std::string(soleDefinition())),
                                  describeEngineUsed(study.breakdown->engine));
    return makeTablePages(settings.setup, {title, {}, title, 0, {}},
                          {{QStringLiteral("By building"), note, makeTable(all, settings)}});
}

}  // namespace

Book makeContributionBook(const Study& study, const BookSettings& settings) {
    Book book =
        beginBook(settings, QStringLiteral("Contributions of buildings"), study.provenance.attribution);
    const Contributions all = collectContributions(study);
    book.pages.push_back(makeNumberedMapPage(study, all, settings));
    book.pages.push_back(makeBarPage(all, settings));
    std::ranges::move(makeShareTablePages(study, all, settings), std::back_inserter(book.pages));
    return book;
}

}  // namespace noonmark
