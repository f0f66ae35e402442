// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Runs a fuzz target without libFuzzer, with the same command line:
///   Fuzz... [-max_total_time=SECONDS] [-seed=N] FOLDER...   mutates the files of the folders
///   Fuzz... FILE...                                         runs these inputs once
/// Mutation is blind (no coverage). The input that ends the program is kept as crash-input.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
// Of the sanitizers' runtime, where the program is built with one.
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*callback)());
// GCC's UndefinedBehaviorSanitizer doesn't know AddressSanitizer's callback: by a signal then.
extern "C" const char* __ubsan_default_options()
{
  return "abort_on_error=1";
}

namespace
{
constexpr std::size_t LargestInput = 1 << 16;
constexpr unsigned SecondsPerInput = 60; // then it counts as a hang

std::string Input;

void KeepInput()
{
  std::ofstream("crash-input", std::ios::binary) << Input;
  std::fprintf(stderr, "The input is in crash-input, %zu bytes.\n", Input.size());
}

void OnSignal(int signal)
{
  std::fprintf(stderr, signal == SIGALRM ? "No end within %u s.\n" : "Signal %u.\n",
    signal == SIGALRM ? SecondsPerInput : static_cast<unsigned>(signal));
  KeepInput();
  _exit(1);
}

void RunInput()
{
  alarm(SecondsPerInput);
  // A copy of exactly this size: AddressSanitizer sees each byte beyond it.
  const std::vector<std::uint8_t> bytes(Input.begin(), Input.end());
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

std::string ReadFile(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

class Mutator
{
public:
  Mutator(std::vector<std::string> seeds, unsigned seed)
    : Seeds(std::move(seeds))
    , Random(seed)
  {
  }

  /// A seed with 1 to 8 changes.
  std::string Next()
  {
    std::string text = this->Seeds[this->Below(this->Seeds.size())];
    for (std::size_t n = 1 + this->Below(8); n > 0; --n)
    {
      this->Change(text);
    }
    text.resize(std::min(text.size(), LargestInput));
    return text;
  }

private:
  std::size_t Below(std::size_t count) { return count > 0 ? this->Random() % count : 0; }

  void Change(std::string& text)
  {
    // What parsers stumble over: limits of the integer types, special numbers, ends of lines.
    static const char* const Words[] = { "0", "-1", "1", "2147483647", "2147483648", "-2147483649",
      "4294967295", "9223372036854775807", "9223372036854775808", "1e400", "1e-400", "nan", "-inf",
      "0x1", "\n", "\r\n", "\t", " ", "#", "/", "//", "\\\n", "1.", ".", "+", "-", "e5" };
    const std::size_t at = this->Below(text.size() + 1);
    const std::size_t length = std::min(text.size() - at, 1 + this->Below(16));
    switch (this->Below(8))
    {
      case 0:
        text.insert(at, 1, static_cast<char>(this->Below(256)));
        break;
      case 1:
        text.replace(at, length, std::string(length, static_cast<char>(this->Below(256))));
        break;
      case 2:
        if (at < text.size())
        {
          text[at] = static_cast<char>(text[at] ^ (1 << this->Below(8)));
        }
        break;
      case 3:
        text.erase(at, length);
        break;
      case 4:
        text.insert(this->Below(text.size() + 1), text.substr(at, 8 * length));
        break;
      case 5:
        this->ReplaceWord(text, at, Words[this->Below(std::size(Words))]);
        break;
      case 6:
        text.erase(at); // truncated
        break;
      default:
      {
        const std::string& other = this->Seeds[this->Below(this->Seeds.size())];
        text = text.substr(0, at) + other.substr(this->Below(other.size() + 1));
      }
    }
  }

  static void ReplaceWord(std::string& text, std::size_t at, const char* word)
  {
    const char* const space = " \t\r\n";
    const std::size_t start = text.find_first_not_of(space, at);
    if (start != std::string::npos)
    {
      const std::size_t end = std::min(text.find_first_of(space, start), text.size());
      text.replace(start, end - start, word);
    }
  }

  std::vector<std::string> Seeds;
  std::mt19937 Random;
};
}

int main(int argc, char** argv)
{
  double seconds = 10;
  unsigned seed = 1;
  std::vector<std::string> seeds;
  std::signal(SIGABRT, OnSignal);
  std::signal(SIGALRM, OnSignal);
  if (__sanitizer_set_death_callback)
  {
    __sanitizer_set_death_callback(KeepInput);
  }
  else
  {
    std::signal(SIGSEGV, OnSignal);
  }
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument.rfind("-max_total_time=", 0) == 0)
    {
      seconds = std::atof(argument.c_str() + 16);
    }
    else if (argument.rfind("-seed=", 0) == 0)
    {
      seed = static_cast<unsigned>(std::atol(argument.c_str() + 6));
    }
    else if (std::filesystem::is_directory(argument))
    {
      // Sorted: the same seed makes the same inputs on each machine.
      std::vector<std::filesystem::path> paths(std::filesystem::directory_iterator(argument), {});
      std::sort(paths.begin(), paths.end());
      std::transform(paths.begin(), paths.end(), std::back_inserter(seeds), ReadFile);
    }
    else if (std::filesystem::exists(argument))
    {
      Input = ReadFile(argument);
      RunInput();
      std::printf("%s: done\n", argument.c_str());
    }
    else
    {
      std::fprintf(stderr, "%s: no such file, folder or option\n", argv[i]);
      return 2;
    }
  }
  if (seeds.empty())
  {
    return 0;
  }
  std::printf("seed %u, %zu files, %g s\n", seed, seeds.size(), seconds);
  std::fflush(stdout);
  for (const std::string& file : seeds)
  {
    Input = file;
    RunInput();
  }
  Mutator mutator(std::move(seeds), seed);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  std::uint64_t runs = 0;
  for (; std::chrono::steady_clock::now() < end; ++runs)
  {
    Input = mutator.Next();
    RunInput();
  }
  std::printf("%llu inputs, nothing found\n", static_cast<unsigned long long>(runs));
  return 0;
}
