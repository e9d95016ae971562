#include "scenarios/weights/score.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/city/trees/tree.h"
#include "core/engines/shade_trees.h"
#include "core/measures/error_sample.h"
#include "core/receivers/rasterize.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/study_cost.h"

namespace noonmark {

namespace {

// Above these limits the maps of all pieces (4 bytes per cell and piece) need too much memory.
constexpr std::size_t maxCellsAtOnce = std::size_t{1} << 27U;
constexpr std::size_t maxPiecesAtOnce = 40;

// Scores one set of steps with a weight table.
class Scoring {
public:
    Scoring(const City& city, const Receivers& receivers, const SunSteps& sun, const Zone& zone,
            const TimeWeights& weights, Progress& progress, std::stop_token stop)
        : city_(city),
          receivers_(receivers),
          sun_(sun),
          weights_(weights),
          pieces_(splitIntoPieces(sun, zone, weights)),
          progress_(progress),
          stop_(std::move(stop)) {}

    /// Chooses the cells that measureErrors() is about, before run().
    void sample(const ErrorSampleSettings& settings) {
        sampled_ = spreadReceivers(receivers_, sampleSize(settings, sun_.steps.size()), settings.seed);
    }

    /// Holds what run() found against rays.
    Result<std::vector<ShownError>> measureErrors() const {
        NoProgress quiet;
        const auto truth =
            traceSets(city_, receivers_, sun_, makeSets(pieces_, sun_), sampled_, quiet, stop_);
        if (!truth) return tl::make_unexpected(truth.error());
        const auto score = differencesOf(*truth, [&](std::size_t i) { return scorePerMinute(pieces_[i]); });
        const auto shade = differencesOf(*truth, [&](std::size_t i) { return weightOf(pieces_[i]) / 60; });
        std::vector<double> off;
        for (const double one : score) off.push_back(std::abs(one));
        if (off.empty()) return std::vector<ShownError>();
        std::vector<ShownError> errors{sumUpError("cell_score", std::move(off)),
                                       sumUpTotalError("score_m2", score, areaM2()),
                                       sumUpTotalError("weighted_shade_m2h", shade, areaM2())};
        for (const bool byMonth : {true, false}) addParts(errors, *truth, byMonth);
        return errors;
    }

    /// run() measures these columns with trees, too.
    void addTrees(TreeColumns columns) {
        shaded_ = withTreesFor(city_, columns);
        if (!shaded_.trees || shaded_.trees->trees.empty()) return;
        for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
            if (isAmong(columns, column)) treeColumns_.push_back(column);
        columns_ = columns;
    }

    Result<Score> run(const Engine& engine) {
        const City* const cities[]{&city_};
        auto choice = engine.choose(cities, receivers_, sun_);
        if (!choice) return by(engine);
        auto score = by(*choice->engine);
        if (score) return stated(*std::move(score), *choice);
        auto other = engine.chooseInstead(*choice, score.error());
        if (!other) return score;
        return by(*other->engine).map([&](Score made) { return stated(std::move(made), *other); });
    }

private:
    double weightOf(const TimePiece& piece) const {
        return piece.interval ? weights_.intervals[*piece.interval].weight : 0;
    }

    double scorePerMinute(const TimePiece& piece) const {
        if (!piece.interval) return 0;
        double sunlit = 0;
        for (const TimePiece& other : pieces_)
            if (other.interval == piece.interval) sunlit += other.sun.sunlitMinutes();
        return weightOf(piece) / sunlit;
    }

    // At each cell of the sample: the engine minus rays, each minute by the factor of its piece.
    template <class Factor>
    std::vector<double> differencesOf(const std::vector<std::vector<double>>& truth, Factor factor) const {
        std::vector<double> differences(sampled_.size(), 0);
        for (std::size_t piece = 0; piece < pieces_.size(); ++piece)
            for (std::size_t cell = 0; cell < sampled_.size(); ++cell)
                differences[cell] += factor(piece) * (minutes_[piece][cell] - truth[piece][cell]);
        return differences;
    }

    [[nodiscard]] double areaM2() const {
        return double(receivers_.cells.size()) * receivers_.grid.cellAreaM2();
    }

    static bool areTogether(const TimePiece& a, const TimePiece& b, bool byMonth) {
        return byMonth ? a.month == b.month : a.interval == b.interval;
    }

    // Of a step in shadow: the share of the sunlit time of its month or interval.
    double sharePerMinute(const TimePiece& piece, bool byMonth) const {
        double sunlit = 0;
        for (const TimePiece& other : pieces_)
            if (areTogether(piece, other, byMonth)) sunlit += other.sun.sunlitMinutes();
        return 1 / sunlit;
    }

    // Of the figures of months, or of intervals.
    void addParts(std::vector<ShownError>& errors, const std::vector<std::vector<double>>& truth,
                  bool byMonth) const {
        const auto add = [&](std::string_view key, const auto& factor) {
            if (auto error = errorOfParts(key, truth, byMonth, factor)) errors.push_back(*error);
        };
        const auto share = [&](std::size_t i) { return sharePerMinute(pieces_[i], byMonth); };
        const auto score = [&](std::size_t i) { return scorePerMinute(pieces_[i]); };
        const auto shade = [&](std::size_t i) { return weightOf(pieces_[i]) / 60; };
        add(byMonth ? "month_shadow_m2" : "interval_shadow_m2", share);
        add(byMonth ? "month_score_m2" : "interval_score_m2", score);
        add(byMonth ? "month_shade_m2h" : "interval_shade_m2h", shade);
    }

    // The mean of the months or intervals, and within what the worst of them lies. None: there are none.
    template <class Factor>
    std::optional<ShownError> errorOfParts(std::string_view key,
                                           const std::vector<std::vector<double>>& truth, bool byMonth,
                                           const Factor& factor) const {
        std::optional<ShownError> all;
        std::size_t parts = 0;
        for (std::size_t first = 0; first < pieces_.size(); ++first) {
            const TimePiece& part = pieces_[first];
            const auto isPart = [&](const TimePiece& one) { return areTogether(one, part, byMonth); };
            const bool isKnown = std::ranges::any_of(std::span(pieces_).first(first), isPart);
            if (isKnown || (!byMonth && !part.interval)) continue;
            const auto differences =
                differencesOf(truth, [&](std::size_t i) { return isPart(pieces_[i]) ? factor(i) : 0.0; });
            const ShownError own = sumUpTotalError(key, differences, areaM2());
            if (!all) all = own;
            if (parts > 0) all->mean += (own.mean - all->mean) / double(parts + 1);
            all->p99 = std::max(all->p99, own.p99);
            ++parts;
        }
        return all;
    }

    static Score stated(Score score, const EngineChoice& choice) {
        score.engine += fmt::format(" (chosen: {})", choice.why);
        score.engineKey = choice.key;
        return score;
    }

    Result<Score> by(const Engine& engine) {
        const bool fits =
            pieces_.size() <= maxPiecesAtOnce && pieces_.size() * receivers_.grid.size() <= maxCellsAtOnce;
        return fits && engine.capabilities().sets ? atOnce(engine) : pieceByPiece(engine);
    }

    Result<Score> atOnce(const Engine& engine) {
        return engine.breakDown(city_, receivers_, sun_, makeSets(pieces_, sun_), false, progress_, stop_)
            .and_then([&](const ShadowBreakdown& breakdown) {
                minutes_ = minutesAt(breakdown, sampled_);
                Score score = sumUp(breakdown);
                score.engine = breakdown.engine;
                return shade(std::move(score), breakdown);
            });
    }

    Score sumUp(const ShadowBreakdown& breakdown) const {
        ScoreSum sum(receivers_, weights_, pieces_);
        for (std::size_t i = 0; i < pieces_.size(); ++i) sum.add(pieces_[i], spreadOverGrid(breakdown, i));
        return std::move(sum).finish();
    }

    Result<Score> shade(Score score, const ShadowBreakdown& without) const {
        if (treeColumns_.empty()) return score;
        return shadeTreeSets(shaded_, receivers_, sun_, without, columns_, progress_, stop_)
            .map([&](const std::optional<ShadedSets>& shaded) {
                if (!shaded) return std::move(score);
                score.treesHow = shaded->how;
                for (const TreeColumns column : treeColumns_)
                    score.withTrees.push_back(withColumn(column, sumUp(*shaded->of(column))));
                return std::move(score);
            });
    }

    static ShadedScore withColumn(TreeColumns column, Score score) {
        return {score, column, std::move(score.score), std::move(score.months), std::move(score.intervals)};
    }

    Result<Score> pieceByPiece(const Engine& engine) {
        ScoreSum sum(receivers_, weights_, pieces_);
        std::vector<ScoreSum> ofColumns(treeColumns_.size(), sum);
        minutes_.clear();
        std::string words, treesHow;
        Warnings warnings;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            ProgressShare share(progress_, i, pieces_.size());
            const auto field = engine.accumulate(city_, receivers_, pieces_[i].sun, share, stop_);
            if (!field) return tl::make_unexpected(field.error());
            const auto days = double(pieces_[i].sun.dayCount());
            sum.add(pieces_[i], field->grossMin, days);
            if (auto done = addShade(pieces_[i], *field, ofColumns, treesHow, share); !done)
                return tl::make_unexpected(done.error());
            std::vector<double>& minutes = minutes_.emplace_back();
            for (const std::uint32_t cell : sampled_) minutes.push_back(double(field->grossMin[cell]) * days);
            words = field->engine;
            if (warnings.empty()) warnings = field->warnings;
        }
        Score score = std::move(sum).finish();
        score.engine = std::move(words);
        score.warnings = std::move(warnings);
        score.treesHow = std::move(treesHow);
        for (std::size_t i = 0; i < treeColumns_.size() && !score.treesHow.empty(); ++i)
            score.withTrees.push_back(withColumn(treeColumns_[i], std::move(ofColumns[i]).finish()));
        return score;
    }

    // `how` stays empty until a tree reaches a receiver.
    Result<void> addShade(const TimePiece& piece, const ShadowField& field, std::vector<ScoreSum>& ofColumns,
                          std::string& how, Progress& progress) const {
        if (treeColumns_.empty()) return {};
        auto shade = shadeTrees(shaded_, receivers_, piece.sun, field, columns_, progress, stop_);
        if (!shade) return tl::make_unexpected(shade.error());
        if (*shade) how = (*shade)->how;
        ShadowField with = field;
        with.trees = *std::move(shade);
        for (std::size_t i = 0; i < treeColumns_.size(); ++i)
            ofColumns[i].add(piece, fieldOfColumn(with, treeColumns_[i]).grossMin,
                             double(piece.sun.dayCount()));
        return {};
    }

    const City& city_;
    const Receivers& receivers_;
    const SunSteps& sun_;
    const TimeWeights& weights_;
    std::vector<TimePiece> pieces_;
    std::vector<std::uint32_t> sampled_{};
    std::vector<std::vector<double>> minutes_{};  // of run(), by piece and sampled cell
    City shaded_{};                               // with its trees weighed
    TreeColumns columns_ = TreeColumns::without;
    std::vector<TreeColumns> treeColumns_{};  // of columns_; empty: there are no trees
    Progress& progress_;
    std::stop_token stop_;
};

}  // namespace

Result<Score> computeScore(const City& city, const Receivers& receivers, const SunSteps& sun,
                           const Zone& zone, const TimeWeights& weights, const Engine& engine,
                           Progress& progress, const std::stop_token& stop, TreeColumns trees) {
    if (const auto sound = validate(weights); !sound) return tl::make_unexpected(sound.error());
    Scoring scoring(city, receivers, sun, zone, weights, progress, stop);
    scoring.addTrees(trees);
    return scoring.run(engine);
}

namespace {

// A missing error fails no score.
Result<void> addErrors(Score& score, Result<std::vector<ShownError>> errors) {
    if (!errors && isCancelled(errors.error())) return tl::make_unexpected(errors.error());
    if (!errors)
        score.warnings.push_back(
            {WarningKind::leftOut, "the error against the ray reference", errors.error().text()});
    else
        score.errors = *std::move(errors);
    return {};
}

Result<Score> placeAndScore(const City& city, const StudySettings& settings, const TimeWeights& weights,
                            Progress& progress, const std::stop_token& stop, const EngineList& engines) {
    if (const auto ground = checkOnGround(settings.receivers.places); !ground)
        return tl::make_unexpected(ground.error());
    const auto engine = makeEngine(settings.engine, settings.engineSettings, engines);
    if (!engine) return tl::make_unexpected(engine.error());
    const auto zone = Zone::named(settings.period.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    if (auto fits = checkMemory(city, settings, engines); !fits) return tl::make_unexpected(fits.error());
    const auto receivers = placeReceiversOnGround(city, settings.region, settings.receivers, stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    if (receivers->cells.empty())
        return failure("No cell of the region lies on open ground", settings.region.name,
                       "Choose a region outside buildings and water, or smaller cells");
    const auto sun = validate(settings.period).and_then([&](const Period& period) {
        return computeDaylightSteps(period, makeObserver(city, settings), stop);
    });
    if (!sun) return tl::make_unexpected(sun.error());
    if (const auto sound = validate(weights); !sound) return tl::make_unexpected(sound.error());
    Scoring scoring(city, *receivers, *sun, *zone, weights, progress, stop);
    const bool wantsErrors = settings.errorSample.receivers > 0;
    if (wantsErrors) scoring.sample(settings.errorSample);
    scoring.addTrees(settings.trees);
    auto score = scoring.run(**engine);
    if (!score) return score;
    if (score->engineKey.empty()) score->engineKey = settings.engine;
    if (wantsErrors && score->engineKey != referenceEngine)
        if (auto done = addErrors(*score, scoring.measureErrors()); !done)
            return tl::make_unexpected(done.error());
    if (auto mismatch = findSeasonMismatch(weights, city.frame.origin().latDeg))
        score->warnings.push_back(*std::move(mismatch));
    return score;
}

}  // namespace

Result<Score> runScore(const City& city, const StudySettings& settings, const TimeWeights& weights,
                       Progress& progress, const std::stop_token& stop, const EngineList& engines) {
    return guardMemory(
        {.what = "this score", .advice = "Choose larger cells, a smaller region or fewer steps"},
        [&] { return placeAndScore(city, settings, weights, progress, stop, engines); });
}

const ShadedScore* findColumn(const Score& score, TreeColumns column) {
    const auto with = std::ranges::find(score.withTrees, column, &ShadedScore::column);
    return with == score.withTrees.end() || with->score.empty() ? nullptr : &*with;
}

TreeColumns columnOf(const Score& score, TreeColumns wanted) {
    return findColumn(score, wanted) ? wanted : TreeColumns::without;
}

const std::vector<float>& scoreInColumn(const Score& score, TreeColumns column) {
    const ShadedScore* with = findColumn(score, column);
    return with ? with->score : score.score;
}

std::shared_ptr<const Score> showColumn(const std::shared_ptr<const Score>& score, TreeColumns column) {
    const ShadedScore* with = findColumn(*score, column);
    if (!with) return score;
    auto made = std::make_shared<Score>(*score);
    static_cast<ScoreTotals&>(*made) = *with;
    made->score = with->score;
    made->months = with->months;
    made->intervals = with->intervals;
    made->withTrees.clear();
    made->errors.clear();
    return made;
}

}  // namespace noonmark
