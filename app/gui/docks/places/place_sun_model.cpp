#include "app/gui/docks/places/place_sun_model.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/region_text.h"
#include "core/describe/shown_as.h"
#include "core/receivers/place_names.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

namespace {

constexpr std::string_view enoughKey = "share_enough", meanKey = "hours_mean", minKey = "hours_min",
                           maxKey = "hours_max";

QString nameOf(const CivilDate& date) { return QLocale().toString(dateOf(date), shortDay()); }

PlaceSunModel::FigureColumn::Above summaryOf(const Figure& figure) {
    using Above = PlaceSunModel::FigureColumn::Above;
    if (figure.use == FigureUse::basis) return Above::sum;
    return figure.key == minKey ? Above::minimum : figure.key == maxKey ? Above::maximum : Above::mean;
}

QString describeRemarks(const SunOfPlace& of) {
    QStringList words;
    for (const std::string_view remark : listRemarks(of)) words << translatedSentence(remark);
    return words.join(QStringLiteral("; "));
}

bool isShare(const Figure& figure) { return figure.unit == FigureUnit::share; }

// Changes are told in minutes throughout.
bool isChangeOfHours(const Figure& figure) { return figure.isChange && figure.unit == FigureUnit::none; }

// Figures with trees have a name of their own.
QString shadowHeading(const Figure& figure, const ShadowFigure& shadow) {
    return figure.key == shadow.sunKey ? QObject::tr("%1, min").arg(translated(shadow.label))
                                       : QObject::tr("%1: minutes of shadow").arg(translated(figure.label));
}

QString columnHeading(const Figure& figure) {
    const QString label = translated(figure.label);
    if (isChangeOfHours(figure)) return QObject::tr("%1, min").arg(label);
    if (isShare(figure)) return QObject::tr("%1, %").arg(label);
    if (figure.unit == FigureUnit::squareMetres) return QObject::tr("%1, m²").arg(label);
    return figure.unit == FigureUnit::minutesADay ? QObject::tr("%1, min").arg(label)
                                                  : QObject::tr("%1, h").arg(label);
}

}  // namespace

PlaceSunModel::PlaceSunModel(QObject* parent) : QAbstractItemModel(parent), nodes_(1) {}

void PlaceSunModel::show(std::shared_ptr<const SunOfCities> sun) {
    beginResetModel();
    sun_ = std::move(sun);
    colours_.clear();
    makeColumns();
    makeNodes();
    endResetModel();
}

void PlaceSunModel::setShown(ShownAs show) {
    if (show == show_) return;
    beginResetModel();
    show_ = show;
    makeColumns();
    makeNodes();
    endResetModel();
}

double PlaceSunModel::possibleHours(const ShownSun& shown) const {
    if (shown.what == ShownSun::What::period) return sun_->baseline.possibleHours;
    const CivilDate& date = sun_->baseline.settings.dates[shown.date];
    return possibleHoursOn(sun_->baseline, [&](const CivilDate& day) { return day == date; });
}

bool PlaceSunModel::showsSun(const ShownSun& shown) const {
    if (show_ == ShownAs::sun) return true;
    return shown.what != ShownSun::What::change && std::isnan(possibleHours(shown));
}

double PlaceSunModel::shownOf(double hours, const ShownSun& shown) const {
    const bool sun = showsSun(shown);
    if (shown.what == ShownSun::What::change) return (sun ? hours : -hours) * minutesPerHour;
    return sun ? hours : (possibleHours(shown) - hours) * minutesPerHour;
}

void PlaceSunModel::restate(std::shared_ptr<const SunOfCities> sun) {
    const double hours = sun->baseline.settings.enoughHours;
    sun_ = std::move(sun);
    setEnough(hours);
}

void PlaceSunModel::setGrouped(bool grouped) {
    if (grouped == grouped_) return;
    beginResetModel();
    grouped_ = grouped;
    makeNodes();
    endResetModel();
}

// Only what the view draws of them changes: no signal for each row.
void PlaceSunModel::setColours(std::vector<QColor> colours) { colours_ = std::move(colours); }

namespace {

// Null: the baseline has no change, and another scenario was not measured.
const ComparedSun* findCompared(const SunOfCities& sun, const std::string& scenario) {
    const auto at = std::ranges::find(sun.compared, scenario, [](const auto& one) { return one.sun.name; });
    return at == sun.compared.end() ? nullptr : &*at;
}

}  // namespace

bool isMeasured(const SunOfCities& sun, const std::string& scenario, const ShownSun& shown) {
    return findCompared(sun, scenario) ||
           (shown.what != ShownSun::What::change && sun.baseline.name == scenario);
}

double hoursOf(const SunOfCities& sun, const std::string& scenario, std::size_t place,
               const ShownSun& shown) {
    const ComparedSun* compared = findCompared(sun, scenario);
    if (shown.what == ShownSun::What::change) return compared->changes[place].meanHours;
    const SunOfPlace& of = (compared ? compared->sun : sun.baseline).sun[place];
    return shown.what == ShownSun::What::period ? of.meanHours : of.dateHours[shown.date];
}

double PlaceSunModel::hoursOf(std::size_t place, const ShownSun& shown) const {
    return noonmark::hoursOf(*sun_, shownCity(*sun_).name, place, shown);
}

void PlaceSunModel::addColumn(FigureColumn column, const std::function<double(std::size_t)>& valueOf) {
    for (std::size_t i = 0; i < sun_->baseline.places.size(); ++i) column.values.push_back(valueOf(i));
    columns_.push_back(std::move(column));
}

void PlaceSunModel::makeColumns() {
    columns_.clear();
    if (!sun_) return;
    const SunByPlace& shown = shownCity(*sun_);
    for (const Figure& figure : sunOfPlaceFigures().rows()) {
        if (figure.use == FigureUse::basis) continue;
        if (figure.key == enoughKey) enough_ = columns_.size();
        if (figure.key == meanKey) mean_ = columns_.size();
        addFigure(figure, shown.sun);
    }
    addChanges();
    addDates();
    addChangesOfDates();
    describeEnough(sun_->baseline.settings.enoughHours);
    for (const SunWithTrees& with : shown.withTrees)
        addFigure(sunFiguresWithTrees(with.column).front(), with.sun);
    for (const Figure& figure : sunOfPlaceFigures().rows())
        if (figure.use == FigureUse::basis) addFigure(figure, shown.sun);
}

void PlaceSunModel::addFigure(const Figure& figure, const std::vector<SunOfPlace>& sun) {
    const double factor = isShare(figure) ? percentOfWhole : 1;
    const ShadowFigure* inShadow = showsSun({}) ? nullptr : findShadow(figure);
    FigureColumn column{inShadow ? shadowHeading(figure, *inShadow) : columnHeading(figure),
                        inShadow ? tr("Minutes of shadow a day: the sunlit time without the sun")
                                 : translatedSentence(figure.definition),
                        isShare(figure) || inShadow ? 0 : figure.shownDecimals,
                        summaryOf(figure),
                        {}};
    if (inShadow && column.above != FigureColumn::Above::mean)
        column.above = column.above == FigureColumn::Above::minimum ? FigureColumn::Above::maximum
                                                                    : FigureColumn::Above::minimum;
    addColumn(std::move(column), [&](std::size_t i) {
        const double value = figure.get(&sun[i]);
        return inShadow ? shownOf(value, {}) : value * factor;
    });
}

// The columns of the shares, which a threshold changes.
void PlaceSunModel::describeEnough(double hours) {
    const QString enough = formatAmount(hours);
    const Figure& figure = findFigure(sunOfPlaceFigures().rows(), enoughKey);
    FigureColumn& column = columns_[enough_];
    column.heading = (show_ == ShownAs::sun ? tr("\u2265 %1 h, %") : tr("\u2265 %1 h sun, %")).arg(enough);
    column.tip = tr("%1 (here: %2 h)").arg(translatedSentence(figure.definition), enough);
    const std::vector<CivilDate>& dates = sun_->baseline.settings.dates;
    for (std::size_t date = 0; date < dates.size(); ++date) {
        FigureColumn& below = columns_[firstDate_ + 2 * date + 1];
        below.heading = (show_ == ShownAs::sun ? tr("%1 < %2 h, %") : tr("%1 < %2 h sun, %"))
                            .arg(nameOf(dates[date]), enough);
        below.tip = tr("Share of the area with less than %1 h of sun on this day").arg(enough);
    }
}

int PlaceSunModel::columnOf(const ShownSun& shown) const {
    const std::size_t column = shown.what == ShownSun::What::change ? firstChange_
                               : shown.what == ShownSun::What::date ? firstDate_ + 2 * shown.date
                                                                    : mean_;
    return firstFigure + int(column);
}

bool PlaceSunModel::followsEnough(int column) const {
    const auto at = std::size_t(column - firstFigure);
    const std::size_t dates = sun_ ? sun_->baseline.settings.dates.size() : 0;
    if (column < firstFigure || !sun_) return false;
    return at == enough_ || (at > firstDate_ && at < firstDate_ + 2 * dates && (at - firstDate_) % 2 == 1);
}

void PlaceSunModel::fillEnough(std::size_t column, const std::function<double(const SunOfPlace&)>& share) {
    FigureColumn& filled = columns_[column];
    const std::vector<SunOfPlace>& sun = shownCity(*sun_).sun;
    for (std::size_t i = 0; i < sun.size(); ++i) filled.values[i] = percentOfWhole * share(sun[i]);
    for (std::size_t node = 1; node < nodes_.size(); ++node)
        if (!nodes_[node].place) nodes_[node].values[column] = valueAbove(int(node), filled);
    Q_EMIT headerDataChanged(Qt::Horizontal, firstFigure + int(column), firstFigure + int(column));
}

void PlaceSunModel::setEnough(double hours) {
    if (!sun_) return;
    const std::vector<SunOfPlace>& sun = shownCity(*sun_).sun;
    if (std::ranges::all_of(sun, [](const SunOfPlace& of) { return of.ofCells.empty(); })) return;
    describeEnough(hours);
    fillEnough(enough_, [hours](const SunOfPlace& of) { return computeEnoughShare(of, hours); });
    for (std::size_t date = 0; date < sun_->baseline.settings.dates.size(); ++date)
        fillEnough(firstDate_ + 2 * date + 1,
                   [hours, date](const SunOfPlace& of) { return computeBelowShare(of, date, hours); });
}

void PlaceSunModel::addDates() {
    const std::vector<SunOfPlace>& sun = shownCity(*sun_).sun;
    const SunByPlaceSettings& settings = sun_->baseline.settings;
    firstDate_ = columns_.size();
    for (std::size_t date = 0; date < settings.dates.size(); ++date) {
        const ShownSun of{ShownSun::What::date, date};
        const bool isSun = showsSun(of);
        addColumn({(isSun ? tr("%1, h") : tr("%1: shadow, min")).arg(nameOf(settings.dates[date])),
                   isSun ? tr("Hours of sun on this day, mean over the place")
                         : tr("Minutes of shadow on this day, mean over the place"),
                   isSun ? 2 : 0,
                   {},
                   {}},
                  [&](std::size_t i) { return shownOf(sun[i].dateHours[date], of); });
        addColumn({{}, {}, 0, {}, {}},
                  [&](std::size_t i) { return sun[i].belowShare[date] * percentOfWhole; });
    }
}

void PlaceSunModel::addChanges() {
    firstChange_ = columns_.size();
    if (sun_->compared.empty()) return;
    const ComparedSun& compared = sun_->compared.back();
    for (const Figure& figure : sunChangeFigures().rows()) {
        const bool inShadow = isChangeOfHours(figure) && show_ != ShownAs::sun;
        const double factor = isShare(figure)           ? percentOfWhole
                              : inShadow                ? -minutesPerHour
                              : isChangeOfHours(figure) ? minutesPerHour
                                                        : 1;
        const QString meaning = inShadow ? tr("Minutes of shadow a day more than in the baseline, mean over "
                                              "the days and the place; negative: less")
                                : isChangeOfHours(figure)
                                    ? tr("Minutes of sun a day more than in the baseline, mean over the days "
                                         "and the place; negative: less")
                                    : translatedSentence(figure.definition);
        const QString tip = tr("%1 (baseline: %2)").arg(meaning, QString::fromStdString(sun_->baseline.name));
        const int decimals = isShare(figure) ? 0 : isChangeOfHours(figure) ? 1 : figure.shownDecimals;
        addColumn({inShadow ? tr("Change of shadow, min") : columnHeading(figure), tip, decimals, {}, {}},
                  [&](std::size_t i) { return figure.get(&compared.changes[i]) * factor; });
    }
}

void PlaceSunModel::addChangesOfDates() {
    if (sun_->compared.empty()) return;
    const std::vector<SunOfPlace>&before = sun_->baseline.sun, &after = sun_->compared.back().sun.sun;
    const SunByPlaceSettings& settings = sun_->baseline.settings;
    for (std::size_t date = 0; date < settings.dates.size(); ++date) {
        const bool isSun = showsSun({ShownSun::What::date, date});
        const double factor = isSun ? minutesPerHour : -minutesPerHour;
        addColumn(
            {(isSun ? tr("%1: change, min") : tr("%1: change of shadow, min"))
                 .arg(nameOf(settings.dates[date])),
             tr("Minutes more than in the baseline on this day, mean over the place; negative: less "
                "(baseline: %1)")
                 .arg(QString::fromStdString(sun_->baseline.name)),
             1,
             {},
             {}},
            [&](std::size_t i) { return factor * (after[i].dateHours[date] - before[i].dateHours[date]); });
    }
}

int PlaceSunModel::addNode(Node node, int parent) {
    const int number = int(nodes_.size());
    node.parent = parent;
    node.row = int(nodes_[std::size_t(parent)].children.size());
    nodes_[std::size_t(parent)].children.push_back(number);
    nodes_.push_back(std::move(node));
    return number;
}

void PlaceSunModel::makeNodes() {
    nodes_.assign(1, {});
    if (!sun_) return;
    const std::vector<Place>& places = sun_->baseline.places;
    nodeOf_.assign(places.size(), 0);
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return places[i].kind; });
    for (const std::size_t place : order) {
        if (!hasOwnName(places[place])) continue;
        const int above = grouped_ ? aboveOf(places[place].kind, false) : 0;
        nodeOf_[place] = addNode({.place = place, .text = {}, .kind = places[place].kind}, above);
    }
    addUnnamedPlaces();
    for (std::size_t node = 1; node < nodes_.size(); ++node)
        if (!nodes_[node].place) summarize(int(node));
}

// The row of a kind, or of its places without a name; made where it is missing.
int PlaceSunModel::aboveOf(PlaceKind kind, bool unnamed) {
    const int parent = unnamed && grouped_ ? aboveOf(kind, false) : 0;
    const QString text = unnamed ? tr("%1 without a name").arg(describeKinds(kind)) : describeKinds(kind);
    for (const int child : nodes_[std::size_t(parent)].children)
        if (!nodes_[std::size_t(child)].place && nodes_[std::size_t(child)].text == text) return child;
    return addNode({.place = {}, .text = text, .kind = kind}, parent);
}

// Below the place that they are part of, else below their kind.
void PlaceSunModel::addUnnamedPlaces() {
    const std::vector<Place>& places = sun_->baseline.places;
    for (std::size_t place = 0; place < places.size(); ++place) {
        if (hasOwnName(places[place])) continue;
        const auto whole = sun_->baseline.partOf[place];
        const int above = whole ? nodeOf_[*whole] : aboveOf(places[place].kind, true);
        nodeOf_[place] = addNode({.place = place, .text = {}, .kind = places[place].kind}, above);
    }
}

std::vector<std::size_t> PlaceSunModel::placesBelow(int node) const {
    std::vector<std::size_t> all;
    for (const int child : nodes_[std::size_t(node)].children) {
        if (const auto place = nodes_[std::size_t(child)].place) {
            all.push_back(*place);
            continue;  // its parts are in it
        }
        const auto below = placesBelow(child);
        all.insert(all.end(), below.begin(), below.end());
    }
    return all;
}

void PlaceSunModel::summarize(int node) {
    Node& above = nodes_[std::size_t(node)];
    above.text = QStringLiteral("%1 (%2)").arg(above.text, formatCount(placesBelow(node).size()));
    for (const FigureColumn& column : columns_) above.values.push_back(valueAbove(node, column));
}

double PlaceSunModel::valueAbove(int node, const FigureColumn& column) const {
    using Above = FigureColumn::Above;
    const std::vector<SunOfPlace>& sun = shownCity(*sun_).sun;
    double sum = 0, weighted = 0, areas = 0, minimum = std::nan(""), maximum = std::nan("");
    for (const std::size_t place : placesBelow(node)) {
        const double value = column.values[place], area = sun[place].areaM2;
        if (std::isnan(value)) continue;
        sum += value;
        weighted += value * area;
        areas += area;
        minimum = std::fmin(minimum, value);
        maximum = std::fmax(maximum, value);
    }
    switch (column.above) {
        case Above::sum:
            return sum;
        case Above::minimum:
            return minimum;
        case Above::maximum:
            return maximum;
        case Above::mean:
            break;
    }
    return weighted / areas;
}

std::optional<std::size_t> PlaceSunModel::placeOf(const QModelIndex& index) const {
    return index.isValid() ? nodes_[index.internalId()].place : std::nullopt;
}

std::optional<PlaceKind> PlaceSunModel::kindOf(const QModelIndex& index) const {
    return index.isValid() ? std::optional(nodes_[index.internalId()].kind) : std::nullopt;
}

QModelIndex PlaceSunModel::indexOf(std::size_t place) const {
    if (!sun_ || place >= nodeOf_.size()) return {};
    const int node = nodeOf_[place];
    return createIndex(nodes_[std::size_t(node)].row, 0, quintptr(node));
}

double PlaceSunModel::valueAt(const QModelIndex& index) const {
    if (index.column() < firstFigure) return std::nan("");
    const auto figure = std::size_t(index.column() - firstFigure);
    const Node& node = nodes_[index.internalId()];
    return node.place ? columns_[figure].values[*node.place] : node.values[figure];
}

QModelIndex PlaceSunModel::index(int row, int column, const QModelIndex& parent) const {
    const std::vector<int>& children = nodes_[parent.isValid() ? parent.internalId() : 0].children;
    if (row < 0 || row >= int(children.size()) || column < 0 || column >= columnCount()) return {};
    return createIndex(row, column, quintptr(children[std::size_t(row)]));
}

QModelIndex PlaceSunModel::parent(const QModelIndex& index) const {
    const int above = index.isValid() ? nodes_[index.internalId()].parent : 0;
    return above == 0 ? QModelIndex() : createIndex(nodes_[std::size_t(above)].row, 0, quintptr(above));
}

int PlaceSunModel::rowCount(const QModelIndex& parent) const {
    if (parent.column() > 0) return 0;
    return int(nodes_[parent.isValid() ? parent.internalId() : 0].children.size());
}

int PlaceSunModel::columnCount(const QModelIndex&) const { return firstFigure + int(columns_.size()); }

QString PlaceSunModel::textOf(const Node& node, int column) const {
    if (column == kind) return describeKind(node.kind);
    if (column == remarks) return node.place ? describeRemarks(shownCity(*sun_).sun[*node.place]) : QString();
    return node.place ? placeName(sun_->baseline.places[*node.place].name) : node.text;
}

QVariant PlaceSunModel::data(const QModelIndex& index, int role) const {
    const Node& node = nodes_[index.internalId()];
    const bool isText = index.column() < firstFigure;
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (isText ? Qt::AlignLeft : Qt::AlignRight));
    if (role == Qt::DecorationRole && index.column() == name && node.place && *node.place < colours_.size())
        return colours_[*node.place];
    if (role == Qt::ToolTipRole && isText) return textOf(node, index.column() == remarks ? remarks : name);
    if (role != Qt::DisplayRole && role != valueRole) return {};
    if (isText) return textOf(node, index.column());
    const double value = valueAt(index);
    if (std::isnan(value)) return {};
    if (role == valueRole) return value;
    return groupDigits(value, columns_[std::size_t(index.column() - firstFigure)].decimals);
}

QVariant PlaceSunModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (section >= firstFigure && role == Qt::ToolTipRole)
        return columns_[std::size_t(section - firstFigure)].tip;
    if (role != Qt::DisplayRole) return {};
    if (section < firstFigure)
        return section == name ? tr("Place") : section == kind ? tr("Kind") : tr("Remarks");
    return columns_[std::size_t(section - firstFigure)].heading;
}

}  // namespace noonmark
