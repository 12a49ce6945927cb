# Crevice on a bare Debian 12, for systems that are not Debian: docker build -t crevice . && docker run --rm crevice
FROM debian:12
WORKDIR /crevice
COPY . .
RUN ./crevice.sh scenes
CMD ["./crevice.sh", "test"]
