#pragma once

// Proves over tables of fields that no setting is forgotten: each field in turn is changed, and JSON,
// options, hash and comparison must all notice.

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/describe/command_options.h"
#include "core/describe/field_json.h"
#include "core/describe/field_values.h"

namespace noonmark::tests {

/// Turns into anything: for counting the members of an aggregate.
struct Anything {
    template <class T>
    operator T() const;  // NOLINT(google-explicit-constructor)
};

template <class S, class... Members>
constexpr int countMembers(Members... members) {
    if constexpr (requires { S{members..., Anything{}}; })
        return countMembers<S>(members..., Anything{});
    else
        return int(sizeof...(Members));
}

/// A value that the field may have, other than this one.
inline Value otherValue(const Field& field, const Value& value) {
    static const std::map<std::string_view, std::string> texts{
        {"start", "2025-02-28"},
        {"from", "07:30"},
        {"window", "sunrise+0.5h..sunset"},
        {"zone", "Asia/Tokyo"},
        {"facing_deg", "90-180"},
        {"range", "0:8"},
        {"classes", "equal:4"},
        {"change_classes", "-30,30"},
        {"points", "id,lon,lat,height,facing\r\na,2.0000000,48.0000000,,\r\n"}};
    switch (field.kind) {
        case ValueKind::yesNo:
            return !std::get<bool>(value);
        case ValueKind::whole:
            return std::get<std::int64_t>(value) + 1;
        case ValueKind::number:
            return (value == Value() ? 0 : std::get<double>(value)) + 0.125;
        case ValueKind::text: {
            const auto known = texts.find(field.key);
            return known == texts.end() ? "another" : known->second;
        }
        case ValueKind::choice:
            return std::string(value == Value(std::string(field.choices.front().key)) ||
                                       field.choices.size() == 1
                                   ? field.choices.back().key
                                   : field.choices.front().key);
        case ValueKind::numbers:
            if (field.key == "extent") return std::vector{12.5, 41.25, 12.75, 41.5};
            return std::vector{12.5, 41.25};
        case ValueKind::texts:
            if (field.key == "dates") return std::vector<std::string>{"2026-12-21", "2026-06-21"};
            return std::vector<std::string>{"one", "another"};
        case ValueKind::namedNumbers:
            return NamedNumbers{{"levels", 3}};
    }
    return {};
}

inline std::set<std::string> namesOf(const std::vector<CommandOption>& options) {
    std::set<std::string> names;
    for (const CommandOption& option : options) names.insert(option.name);
    return names;
}

/// Changes each field of `standard` where it applies, and holds all interfaces against it.
template <class S>
void expectNoticed(const Fields<S>& fields, const S& standard) {
    for (const Field& field : fields.rows()) {
        if (!fields.of(standard).applies(field)) continue;
        S changed = standard;
        const Value other = otherValue(field, field.get(&standard));
        ASSERT_TRUE(field.set(&changed, other)) << field.key;
        EXPECT_EQ(field.get(&changed), other) << field.key;
        EXPECT_FALSE(changed == standard) << field.key << ": the comparison does not notice";
        EXPECT_NE(fieldsJson(fields.of(changed)), fieldsJson(fields.of(standard))) << field.key;
        S back = standard;
        ASSERT_TRUE(readFieldsJson(fields.of(back), fieldsJson(fields.of(changed)))) << field.key;
        EXPECT_TRUE(back == changed) << field.key << ": JSON loses it";
        if (!field.flag.empty()) {
            EXPECT_NE(listOptions(fields.of(changed)), listOptions(fields.of(standard))) << field.key;
        }
        EXPECT_EQ(questionText(fields.of(changed)) != questionText(fields.of(standard)),
                  field.role == SettingRole::question)
            << field.key;
    }
}

}  // namespace noonmark::tests
