#pragma once

#include <QAbstractItemModel>
#include <QSortFilterProxyModel>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/questions/question.h"

namespace noonmark {

/// What of the sun is coloured and held against the threshold: the hours over the period, those of one of the
/// dates, or the change against the baseline.
struct ShownSun {
    enum class What { period, date, change };
    What what = What::period;
    std::size_t date = 0;  ///< of SunByPlaceSettings::dates
    bool operator==(const ShownSun&) const = default;
};

/// Whether it is known of a scenario: a baseline has no change.
bool isMeasured(const SunOfCities& sun, const std::string& scenario, const ShownSun& shown);
/// Hours of a place, NaN without a cell. The scenario must be measured.
double hoursOf(const SunOfCities& sun, const std::string& scenario, std::size_t place, const ShownSun& shown);

/// The places that were measured as a table whose columns are the figures of their tables
/// (sunOfPlaceFigures(), sunChangeFigures()), those of the dates between, and the mean with each shade of
/// trees. Pieces without a name of their own stand below the place that they lie in, or together below one
/// row of their kind; grouped, all stand below their kind. Rows above places have the means of their places,
/// by area, the least and the most of them, or the sum; what is part of a listed place does not count again.
class PlaceSunModel final : public QAbstractItemModel {
    Q_OBJECT
public:
    enum Column { name, kind, remarks, firstFigure };
    static constexpr int valueRole = Qt::UserRole;  ///< a number where the text is one

    struct FigureColumn {
        QString heading, tip;
        int decimals = 2;
        enum class Above { mean, sum, minimum, maximum };
        Above above = Above::mean;  ///< of rows above places
        std::vector<double> values;
    };

    explicit PlaceSunModel(QObject* parent = nullptr);

    void show(std::shared_ptr<const SunOfCities> sun);  ///< null: no rows
    /// Shadow is to be shown, but the sunlit time is not known.
    [[nodiscard]] bool showsSunOnly(const ShownSun& shown) const {
        return show_ == ShownAs::shadow && showsSun(shown);
    }
    /// Hours of sun, or minutes of shadow where the sunlit time of the period or date is known.
    void setShown(ShownAs show);
    /// Of a place, in the unit shown: hours of sun, minutes of shadow or, of a change, minutes of either.
    [[nodiscard]] double shownOf(double hours, const ShownSun& shown) const;
    /// Whether that is hours of sun, or more of it.
    [[nodiscard]] bool showsSun(const ShownSun& shown) const;
    void setGrouped(bool grouped);
    /// The same places with other hours that are enough: rows, their order and what is open stay.
    void restate(std::shared_ptr<const SunOfCities> sun);
    /// The shares with enough sun, and those below it on the dates, are those of so many hours a day, where
    /// the answer has its cells: a saved one has the shares of the hours that were asked for. No signal for
    /// each row, but for the headings.
    void setEnough(double hours);
    /// Whether a column changes with setEnough().
    [[nodiscard]] bool followsEnough(int column) const;
    [[nodiscard]] int enoughColumn() const { return firstFigure + int(enough_); }
    /// The column with the hours, or minutes, of what is shown.
    [[nodiscard]] int columnOf(const ShownSun& shown) const;
    [[nodiscard]] const std::shared_ptr<const SunOfCities>& sun() const { return sun_; }
    /// Hours a day of a place; NaN: no cell.
    [[nodiscard]] double hoursOf(std::size_t place, const ShownSun& shown) const;
    void setColours(std::vector<QColor> colours);  ///< of each place

    [[nodiscard]] std::optional<std::size_t> placeOf(const QModelIndex& index) const;  ///< none: of several
    [[nodiscard]] QModelIndex indexOf(std::size_t place) const;
    [[nodiscard]] double valueAt(const QModelIndex& index) const;  ///< NaN: none
    [[nodiscard]] std::optional<PlaceKind> kindOf(const QModelIndex& index) const;

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Node {
        std::optional<std::size_t> place;
        QString text;  ///< of a row above places
        PlaceKind kind = PlaceKind::other;
        int parent = 0, row = 0;
        std::vector<int> children{};
        std::vector<double> values{};  ///< of a row above places
    };
    [[nodiscard]] double possibleHours(const ShownSun& shown) const;
    void makeColumns();
    void describeEnough(double hours);
    void fillEnough(std::size_t column, const std::function<double(const SunOfPlace&)>& share);
    void addFigure(const Figure& figure, const std::vector<SunOfPlace>& sun);
    void addColumn(FigureColumn column, const std::function<double(std::size_t)>& valueOf);
    void addDates();
    void addChangesOfDates();
    void addChanges();
    void makeNodes();
    int addNode(Node node, int parent);
    int aboveOf(PlaceKind kind, bool unnamed);
    void addUnnamedPlaces();
    void summarize(int node);
    [[nodiscard]] double valueAbove(int node, const FigureColumn& column) const;
    [[nodiscard]] std::vector<std::size_t> placesBelow(int node) const;
    [[nodiscard]] QString textOf(const Node& node, int column) const;

    std::shared_ptr<const SunOfCities> sun_;
    ShownAs show_ = ShownAs::sun;
    bool grouped_ = false;
    std::vector<FigureColumn> columns_;
    std::size_t mean_ = 0;         ///< of the columns, the mean over the period
    std::size_t enough_ = 0;       ///< likewise, the share with enough sun
    std::size_t firstChange_ = 0;  ///< likewise, the change of the mean
    std::size_t firstDate_ = 0;    ///< likewise, the hours of the first date, followed by the share below
    std::vector<Node> nodes_;      ///< 0: above all
    std::vector<int> nodeOf_;      ///< of each place
    std::vector<QColor> colours_;  ///< of each place
};

/// Over a PlaceSunModel: only places whose name contains a text, of one kind, with less sun than a limit.
class PlaceSunFilter final : public QSortFilterProxyModel {
    Q_OBJECT
public:
    explicit PlaceSunFilter(QObject* parent = nullptr);

    void setText(const QString& text);
    void setKind(std::optional<PlaceKind> kind);  ///< none: all
    /// Less sun than so many hours a day, or more.
    struct Limit {
        ShownSun of;
        double hours = 0;
        bool isAbove = false;                              ///< true: those with more sun, that is less shade
        [[nodiscard]] bool holds(double sunHours) const {  ///< false of NaN
            return isAbove ? sunHours > hours : sunHours < hours;
        }
        bool operator==(const Limit&) const = default;
    };
    void setLimit(std::optional<Limit> limit);  ///< none: however much
    /// The place itself, not only one that is part of it.
    [[nodiscard]] bool accepts(std::size_t place) const;
    [[nodiscard]] std::optional<PlaceKind> kind() const { return kind_; }

protected:
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    [[nodiscard]] const PlaceSunModel& model() const;

    QString text_;
    std::optional<PlaceKind> kind_;
    std::optional<Limit> limit_;
};

}  // namespace noonmark
