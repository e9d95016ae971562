#pragma once

#include <array>
#include <filesystem>
#include <fstream>

#include "app/questions/question.h"

namespace noonmark::test {

/// A question that nobody has written a line for outside this file.
struct Toy {
    StudySettings settings;
    std::string scenario;
    double treesFelled = 0;
};

inline const Figures<Toy>& toyFigures() {
    static const Figures<Toy> figures{figure(
        &Toy::treesFelled, {.key = "trees_felled", .label = "Trees felled", .definition = "by a toy"})};
    return figures;
}

inline const Question& toyQuestion();

class ToyAnswer final : public AnswerOf<Toy> {
public:
    using AnswerOf<Toy>::AnswerOf;
    [[nodiscard]] const Question& question() const override { return toyQuestion(); }
    [[nodiscard]] const StudySettings* settings() const override { return &content().settings; }
    [[nodiscard]] MeasuredPart part() const override {
        return {content().scenario, {}, content().settings.region, {}};
    }
    [[nodiscard]] const Warnings& warnings() const override { return warnings_; }
    [[nodiscard]] double seconds() const override { return 0; }
    [[nodiscard]] std::vector<FigureLine> figures() const override {
        return listLines(toyFigures().of(content()));
    }
    [[nodiscard]] std::shared_ptr<const Answer> updated(const Project&, const std::string&,
                                                        const std::string&) const override {
        return nullptr;
    }
    [[nodiscard]] std::shared_ptr<const Answer> stated(Provenance) const override {
        return std::make_shared<ToyAnswer>(shared());
    }
    [[nodiscard]] std::string json() const override { return figuresJson(toyFigures().of(content())).dump(); }
    [[nodiscard]] SavedResult toSave(const Project&) const override {
        return {.name = {},
                .kind = "toy",
                .scenario = content().scenario,
                .settings = json(),
                .grid = {0, 0, 1, 1, 1}};
    }
    [[nodiscard]] std::vector<std::string> fileNames(const AnswerFiles&) const override {
        return {"toy.json"};
    }
    [[nodiscard]] Result<std::vector<std::filesystem::path>> write(const City&,
                                                                   const std::filesystem::path& folder,
                                                                   const AnswerFiles&) const override {
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "toy.json") << json();
        return std::vector{folder / "toy.json"};
    }

private:
    Warnings warnings_;
};

inline const Question& toyQuestion() {
    static const Question question{
        .key = "toy",
        .label = "Toy",
        .compute = [](const Asked& asked, Progress&,
                      const std::stop_token&) -> Result<std::shared_ptr<const Answer>> {
            return std::make_shared<ToyAnswer>(std::make_shared<const Toy>(
                Toy{asked.settings, asked.scenario, double(asked.loaded.read.city.buildings.size())}));
        },
        .figures = toyFigures().rows(),
        .help = "Fell a tree for each building",
        .fileNames = {"toy.json"}};
    return question;
}

}  // namespace noonmark::test
