"""A large log from a small one: its samples again and again, each time later.

    python3 benches/diagnosis/large.py flight.ulg large.ulg [megabytes]

Of the memory that `mavc diagnose` takes for it: /usr/bin/time -v target/release/mavc diagnose large.ulg spec.mav
"""

import pathlib
import sys

PAUSE = 20_000  # us between two repetitions: one sample at 50 Hz


def main():
    source = bytearray(pathlib.Path(sys.argv[1]).read_bytes())
    size = 1_000_000 * int(sys.argv[3] if len(sys.argv) > 3 else 1000)
    places, begin = [], None
    at = 16
    while at + 3 <= len(source):
        length, kind = int.from_bytes(source[at : at + 2], "little"), source[at + 2]
        if kind == ord("D"):
            begin = at if begin is None else begin
            places.append(at + 5)
        at += 3 + length
    times = [int.from_bytes(source[place : place + 8], "little") for place in places]
    step = max(times) - min(times) + PAUSE
    with open(sys.argv[2], "wb") as out:
        out.write(source[:begin])
        block = source[begin:at]
        while out.tell() < size:
            out.write(block)
            times = [time + step for time in times]
            for place, time in zip(places, times):
                block[place - begin : place - begin + 8] = time.to_bytes(8, "little")
    print(f"{sys.argv[2]}: {size // 1_000_000} MB, {times[0] / 1e6:.0f} s")


if __name__ == "__main__":
    main()
