// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/errors.h"
#include "core/random.h"
#include "tests/support/seed.h"

using dsc::io::Json;

namespace {

// A random value, nested at most `depth` deep.
Json random_value(dsc::core::Random& random, int depth) {
    switch (random.below(depth > 0 ? 7 : 5)) {
        case 0: return nullptr;
        case 1: return random.below(2) == 0;
        case 2: return static_cast<std::int64_t>(random.below(1u << 30)) - (1 << 29);
        case 3: return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(600)) - 300);
        case 4: {
            std::string text;
            for (std::uint64_t n = random.below(8); n > 0; --n) text += static_cast<char>(random.below(128));
            return text + "\u03bb\n\"\\</";
        }
        case 5: {
            Json array = Json::array();
            for (std::uint64_t n = random.below(5); n > 0; --n) array.push_back(random_value(random, depth - 1));
            return array;
        }
        default: {
            Json object = Json::object();
            for (std::uint64_t n = random.below(5); n > 0; --n) {
                object["key" + std::to_string(random.below(100))] = random_value(random, depth - 1);
            }
            return object;
        }
    }
}

}  // namespace

TEST_CASE("any JSON value is read back as the same value") {
    dsc::core::Random random(dsc::tests::seed(8));
    for (int i = 0; i < 3000; ++i) {
        const Json value = random_value(random, 4);
        REQUIRE(Json::parse(value.dump()) == value);
        REQUIRE(Json::parse(value.dump(2)) == value);
    }
}

TEST_CASE("members keep their order and arrays of numbers stay on a line") {
    Json report = Json::object({{"zeta", 1}, {"alpha", std::vector<double>{1, 2.5}}});
    report["middle"].push_back(Json::object({{"is_end", true}}));
    CHECK(report.dump() == R"({"zeta":1,"alpha":[1.0,2.5],"middle":[{"is_end":true}]})");
    CHECK(
        report.dump(2) ==
        "{\n  \"zeta\": 1,\n  \"alpha\": [1.0, 2.5],\n  \"middle\": [\n    {\n      \"is_end\": true\n    }\n  ]\n}\n");
    CHECK(report["middle"][0]["is_end"].boolean());
    CHECK(report["alpha"].size() == 2);
    CHECK(report.has("zeta"));
    CHECK_FALSE(report.has("beta"));
}

TEST_CASE("what JSON can't say is written so that it stays JSON") {
    CHECK(Json(std::nan("")).dump() == "null");
    CHECK(Json(INFINITY).dump() == "null");
    CHECK_NOTHROW(Json::parse(Json("\xff\xfe name").dump()));
}

TEST_CASE("wrong JSON and wrong kinds of values are refused") {
    for (const char* text : {"", "{", "[1,]", "nan", "{\"a\":1}x", "1e999"}) {
        INFO(text);
        CHECK_THROWS_AS(Json::parse(text), dsc::core::InputError);
    }
    CHECK_THROWS_WITH(Json::parse("{\n\"a\": x}", "r.json"), Catch::Contains("r.json: line 2"));
    CHECK_THROWS_WITH(Json::parse(R"([{"a": 1}, {"a": 1, "b": {"a": 2}, "a": 3}])", "r.json"),
                      Catch::Contains("\"a\": is there twice"));
    const Json value = Json::object({{"a", 1}});
    CHECK_THROWS_AS(value["b"], dsc::core::InputError);
    CHECK_THROWS_AS(value["a"].string(), dsc::core::InputError);
    CHECK_THROWS_AS(value.number(), dsc::core::InputError);
    CHECK_THROWS_AS(Json::array()[0], dsc::core::InputError);
}
